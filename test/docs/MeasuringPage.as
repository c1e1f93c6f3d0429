package docs
{
    import org.flexunit.asserts.assertEquals;

    /** For docs/measuring.md. */
    public class MeasuringPage extends CollisionMonitorPage
    {
        public static const FIXTURES:Array = [];

        public function MeasuringPage()
        {
            collision.onCollision("bears", "paintballs", function(bear:Object, ball:Object):void
                {
                });
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            super.check(shown);
            assertEquals(1, shown["recorder"].frames);
            assertEquals(1, shown["recorder"].collisions);
            assertEquals(1, shown["recorder"].findTimes.frames);
            assertEquals(1, shown["recorder"].frameTimes.frames);
        }
    }
}
