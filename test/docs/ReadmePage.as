package docs
{
    import org.flexunit.asserts.assertEquals;
    import support.Fixtures;

    /** For README.md: text of a model, and what the first frame does. */
    public class ReadmePage extends Page
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        protected var bearText:String = Fixtures.text("/assets/bear.obj");

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertEquals(1, shown["collision"].statistics.collisions);
            assertEquals(1, shown["collision"].statistics.handlerCalls);
        }
    }
}
