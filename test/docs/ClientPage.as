package docs
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import support.Fixtures;

    /** For docs/client.md: a model's text, and what two handlers do. */
    public class ClientPage extends Page
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        protected var bearText:String = Fixtures.text("/assets/bear.obj");

        private var _painted:int = 0;

        protected function paint(collider:Agent, collidee:Agent):void
        {
            _painted++;
        }

        protected function stop(collider:Agent, wall:Agent):void
        {
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertEquals("by the ten lines, and by the block", 2, _painted);
            assertTrue(shown["bear"].hierarchical);
        }
    }
}
