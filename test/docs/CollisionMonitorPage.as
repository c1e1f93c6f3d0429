package docs
{
    import org.flexunit.asserts.assertEquals;
    import starlogo.diagnostics.CollisionMonitor;

    /** For the ASDoc of CollisionMonitor. What a test puts on the stage it takes away again. */
    public class CollisionMonitorPage extends Page
    {
        public static const FIXTURES:Array = [];

        private var _before:int;

        public function CollisionMonitorPage()
        {
            _before = stage.numChildren;
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertEquals(_before + 1, stage.numChildren);
            assertEquals(collision, CollisionMonitor(stage.removeChild(stage.getChildAt(_before))).collision);
        }
    }
}
