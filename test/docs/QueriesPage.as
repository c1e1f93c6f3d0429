package docs
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.collision.Contact;

    /** For docs/queries.md: a wolf, its friend and some sheep. */
    public class QueriesPage extends Page
    {
        public static const FIXTURES:Array = [];

        protected var wolf:Agent = new Agent("sphere", "wolves");
        protected var friend:Agent = new Agent("sphere", "wolves");

        protected var delta:Number = 0.02;
        protected var contact:Contact = new Contact();

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

        protected function splash(point:Vector3D):void
        {
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
            assertEquals("inside of the first", 0, shown.hit.distance);
            assertEquals(agents[2], shown.hit.agent);
            assertEquals(9, shown.hits.length);
            assertEquals("others are in between", false, shown.isInSight);
            assertTrue("it slides", wolf.y > 0);
            assertTrue("the camera", shown.camera.x <= shown.eye.x);
            assertTrue("the way back is not free", shown.bump != null && shown.bumps.length > 0);
        }
    }
}
