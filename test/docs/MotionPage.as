package docs
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;

    /** For docs/motion.md: a ball that flies through the bear between two frames. */
    public class MotionPage extends Page
    {
        public static const FIXTURES:Array = [];

        private var _splashes:Vector.<Vector3D> = new Vector.<Vector3D>();

        protected function splash(point:Vector3D):void
        {
            _splashes.push(point.clone());
        }

        protected function bump(bear:Agent, wall:Agent):void
        {
        }

        protected function walkOn(bear:Agent, wall:Agent):void
        {
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            ball.jumpTo(-5, 0, 0.4);
            collision.update(agents);
            ball.moveTo(5, 0, 0.4);
            collision.update(agents);
            assertEquals(1, _splashes.length);
            assertTrue("on the bear's near side: " + _splashes[0], Math.abs(_splashes[0].x + 0.5) < 0.01);
            assertEquals("the ball is gone", -1, agents.indexOf(ball));
            agents.push(ball);
            ball.heading = 30;
            ball.jumpTo(50.4, 20, 0);
            collision.update(agents);
            assertTrue("it comes back: " + ball.heading, Math.abs(Math.cos(Math.PI / 180 * (ball.heading - 150)) - 1) < 1e-9);
        }
    }
}
