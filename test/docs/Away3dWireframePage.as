package docs
{
    import away3d.containers.Scene3D;
    import org.flexunit.asserts.assertEquals;
    import starlogo.away3d.Away3dWireframe;

    /** For the ASDoc of Away3dWireframe. */
    public class Away3dWireframePage extends Page
    {
        public static const FIXTURES:Array = [];

        protected var scene:Scene3D = new Scene3D();

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            bear.moveTo(3, 4, 5);
            Away3dWireframe(shown["wireframe"]).update();
            assertEquals(3, shown["wireframe"].x);
        }
    }
}
