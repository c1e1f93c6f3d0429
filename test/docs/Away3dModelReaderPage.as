package docs
{
    import away3d.entities.Mesh;
    import away3d.primitives.CubeGeometry;
    import flash.events.Event;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import starlogo.models.ModelLoader;

    /** For the ASDoc of Away3dModelReader. */
    public class Away3dModelReaderPage extends Page
    {
        public static const FIXTURES:Array = [];

        protected var mesh:Mesh = new Mesh(new CubeGeometry(2, 2, 2));
        protected var loader:ModelLoader;

        public function Away3dModelReaderPage()
        {
            loader = new ModelLoader(greatLand);
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            Async.handleEvent(this, loader, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertTrue(greatLand.hasModel("bear"));
                }, 120000);
        }
    }
}
