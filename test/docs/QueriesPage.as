package docs
{
    import org.flexunit.asserts.assertEquals;
    import starlogo.agents.Agent;

    /** For docs/queries.md: a wolf, its friend and some sheep. */
    public class QueriesPage extends Page
    {
        public static const FIXTURES:Array = [];

        protected var wolf:Agent = new Agent("sphere", "wolves");
        protected var friend:Agent = new Agent("sphere", "wolves");

        private var _howls:int = 0;

        public function QueriesPage()
        {
            agents.length = 0;
            agents.push(wolf, friend);
            for (var i:int = 1; i <= 9; i++)
            {
                var sheep:Agent = new Agent("sphere", i % 3 == 0 ? "lambs" : "sheep");
                sheep.moveTo(0.3 * i, 0, 0);
                sheep.size = i < 5 ? 1 : 0.5;
                agents.push(sheep);
            }
        }

        protected function howl():void
        {
            _howls++;
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertEquals("it touches some", 1, _howls);
            assertEquals(agents[2], shown.prey);
            assertEquals(10, shown.crowd);
            assertEquals(9, shown.seen.length);
            assertEquals("the first that is smaller", agents[6], shown.weaker);
        }
    }
}
