package starlogo.models
{
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.IOErrorEvent;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.async.Async;
    import support.RecordingURLLoader;
    import support.SlowReceiver;
    import support.encoded;

    /** Transform files that a ModelLoader finds beside models. */
    public class TransformsLoadingTest
    {
        private static const OBJ:String = "v 0 0 0\nv 2 0 0\nv 0 4 0\nv 0 0 8\nf 1 2 3\nf 1 2 4\n";

        private var _loader:TestedLoader = new TestedLoader(new SlowReceiver(0), 8);
        private var _log:Array = [];

        [Before]
        public function setUp():void
        {
            _loader.addEventListener(ModelEvent.LOADED, function(event:ModelEvent):void
                {
                    _log.push(event.model.name + " " + event.model.vertices.join());
                });
            _loader.addEventListener(ErrorEvent.ERROR, function(event:ErrorEvent):void
                {
                    _log.push(event.text);
                });
        }

        [Test]
        public function areOfTheSameHost():void
        {
            _loader.usesTransforms = true;
            _loader.load("a", "https://host.com");
            _loader.load("a", "https://host.com?a.obj");
            _loader.load("a", "models/");
            assertEquals("https://host.com,https://host.com?a.obj,models/", addresses());
            _loader.cancel();
        }

        [Test]
        public function areNotAskedForUnlessWanted():void
        {
            _loader.load("a", "bear.obj");
            assertEquals("bear.obj", addresses());
            _loader.usesTransforms = true;
            _loader.load("a", "bear.obj", new ModelTransform());
            _loader.load("a", "data:text/plain,v 0 0 0");
            _loader.loadText("a", OBJ);
            assertEquals("bear.obj,bear.obj,data:text/plain,v 0 0 0", addresses());
            _loader.cancel();
        }

        [Test]
        public function areBesideTheModel():void
        {
            _loader.usesTransforms = true;
            _loader.load("a", "a.b/bear.obj");
            _loader.load("a", "http://host/a.b/bear?x=1.5#y");
            _loader.load("a", "../bear.old.dae?v=2");
            assertEquals("a.b/bear.obj,a.b/bear.slb,http://host/a.b/bear?x=1.5#y,http://host/a.b/bear.slb?x=1.5#y,../bear.old.dae?v=2,"
                    + "../bear.old.slb?v=2", addresses());
            _loader.cancel();
            assertEquals(1, _loader.fetches[1].closeCount);
        }

        [Test(async, timeout="150000")]
        public function standInPlaceOfTheUpAxis():void
        {
            var turned:ModelTransform = ModelTransform.fromText("rotate 90 0 270\nscale 1 2 3");
            _loader.usesTransforms = true;
            _loader.load("turned", "0.obj", "x", Model.VOLUME);
            _loader.load("missing", "1.obj", "y");
            _loader.load("nothing said", "2.obj", "y");
            _loader.load("given", "3.obj", turned, Model.AS_GIVEN);
            // the transform first, or last: the model waits for it
            _loader.fetches[1].deliver(encoded("\uFEFF" + turned));
            _loader.fetches[0].deliver(encoded(OBJ));
            _loader.fetches[2].deliver(encoded(OBJ));
            _loader.fetches[3].dispatchEvent(new IOErrorEvent(IOErrorEvent.IO_ERROR, false, false, "404"));
            _loader.fetches[4].deliver(encoded(OBJ));
            _loader.fetches[5].deliver(encoded("<html>not here</html>"));
            _loader.fetches[6].deliver(encoded(OBJ));
            assertEquals(7, _loader.fetches.length);
            Async.handleEvent(this, _loader, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    var upright:String = new ObjModel("a", OBJ, "y").vertices.join();
                    assertEquals("turned " + new ObjModel("a", OBJ, turned, Model.VOLUME).vertices.join() + "\nmissing " + upright +
                            "\nnothing said " + upright + "\ngiven " + new ObjModel("a", OBJ, turned, Model.AS_GIVEN).vertices.join(), _log.join("\n"));
                }, 120000);
        }

        [Test(async, timeout="150000")]
        public function aTransformMovesWhatIsGiven():void
        {
            _loader.loadText("c", OBJ, new ModelTransform(null, null, new Vector3D(1, 0, 0)), Model.AS_GIVEN);
            Async.handleEvent(this, _loader, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals("c 1,0,0,3,0,0,1,4,0,1,0,8", _log.join());
                }, 120000);
        }

        private function addresses():String
        {
            var all:Array = [];
            for each (var fetch:RecordingURLLoader in _loader.fetches)
            {
                all = all.concat(fetch.addresses);
            }
            return all.join();
        }
    }
}
