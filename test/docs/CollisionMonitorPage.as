package docs
{
    import org.flexunit.asserts.assertEquals;
    import starlogo.diagnostics.CollisionMonitor;

    /** For the ASDoc of CollisionMonitor. What a test puts on the stage it takes away again. */
    public class CollisionMonitorPage extends Page
    {
        public static const FIXTURES:Array = [];

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertEquals(collision, CollisionMonitor(stage.removeChild(stage.getChildAt(stage.numChildren - 1))).collision);
        }
    }
}
