package starlogo.models
{
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.ProgressEvent;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import support.Collada;
    import support.SlowReceiver;
    import support.assertThrows;
    import support.encoded;

    public class ModelLoaderTest
    {
        public static const FIXTURES:Array = ["/assimp/OBJ/spider.obj"];

        private static const OBJ:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
        private static const DOCUMENT:String = Collada.document(Collada.geometry("a", "0 0 0 1 0 0 1 1 0",
                    Collada.triangles("0 1 2")));

        private var _receiver:SlowReceiver = new SlowReceiver(0);
        private var _loader:ModelLoader = new ModelLoader(_receiver);
        private var _log:Array = [];

        [Before]
        public function setUp():void
        {
            _loader.addEventListener(ModelEvent.LOADED, function(event:ModelEvent):void
                {
                    _log.push(event.model.name);
                });
            _loader.addEventListener(ErrorEvent.ERROR, function(event:ErrorEvent):void
                {
                    _log.push(event.text);
                });
        }

        [Test(async, timeout="150000")]
        public function choosesTheReader():void
        {
            _loader.loadText("obj text", OBJ);
            _loader.loadText("COLLADA text", "\uFEFF \n" + DOCUMENT);
            _loader.loadBytes("obj bytes", encoded(OBJ), "y");
            _loader.loadBytes("COLLADA bytes", encoded(DOCUMENT));
            whenComplete(function():void
                {
                    assertEquals("obj text,COLLADA text,obj bytes,COLLADA bytes", _log.join());
                    assertEquals(_log.join(), _receiver.received.join());
                });
        }

        [Test(async, timeout="150000")]
        public function takesModelsFromSources():void
        {
            var maker:CountedMaker = new CountedMaker("made", 5, false);
            _loader.budget = 0;
            var progress:Array = [];
            _loader.addEventListener(ProgressEvent.PROGRESS, function(event:ProgressEvent):void
                {
                    progress.push(event.bytesLoaded / event.bytesTotal);
                });
            _loader.loadFrom(maker);
            _loader.loadFrom(new CountedMaker("broken", 2, true));
            _loader.loadText("text", OBJ);
            assertTrue(_loader.isPending("made"));
            assertEquals("made,broken,text", _receiver.expected.join());
            assertEquals(0, maker.done);
            whenComplete(function():void
                {
                    assertEquals('made,model "broken": it can\'t be added: no more,text', _log.join());
                    assertEquals("made,text", _receiver.received.join());
                    assertEquals(5, maker.done);
                    assertTrue("a step a frame: " + progress, progress.length > 20);
                    assertTrue("half of a third for what is read: " + progress, progress[2] > progress[1] && Math.abs(progress[5] - 0.16) < 0.011);
                });
        }

        [Test]
        public function noSourceIsAnError():void
        {
            assertThrows(ArgumentError, /maker .*must/, _loader.loadFrom, null);
            assertEquals(0, _loader.pendingCount);
        }

        [Test(async, timeout="150000")]
        public function fetchesFiles():void
        {
            _loader.load("missing", "/fixtures/models/missing.obj");
            _loader.load("list", "/fixtures/models/expected.json?x=.dae");
            _loader.loadText("text", OBJ);
            assertTrue(_loader.isPending("missing"));
            whenComplete(function():void
                {
                    _log.sort();
                    assertEquals(3, _log.length);
                    assertTrue(_log[0], _log[0].indexOf("model \"list\": no vertices") == 0);
                    assertTrue(_log[1], _log[1].indexOf("model \"missing\": its file can't be fetched") == 0);
                    assertFalse(_log[1], /#\d|Stream Error/.test(_log[1]));
                    assertEquals("text", _log[2]);
                    assertFalse(_loader.isPending("missing"));
                });
        }

        [Test(async, timeout="150000")]
        public function tellsTheProgressOfAnEmptyText():void
        {
            var done:Array = [];
            _loader.budget = 0;
            _loader.addEventListener(ProgressEvent.PROGRESS, function(event:ProgressEvent):void
                {
                    done.push(event.bytesLoaded);
                });
            _loader.loadText("empty", "");
            whenComplete(function():void
                {
                    assertEquals(1, _log.length);
                    for each (var hundredths:Number in done)
                    {
                        assertTrue(done.join(), hundredths >= 0 && hundredths <= 100);
                    }
                });
        }

        [Test(async, timeout="150000")]
        public function goesOnAfterAnError():void
        {
            _loader.loadText("broken", "v 1 2");
            _loader.loadText("refused", OBJ);
            _loader.loadText("good", OBJ);
            _receiver.refuse("refused");
            whenComplete(function():void
                {
                    assertEquals(3, _log.length);
                    assertTrue(_log[0], _log[0].indexOf("model \"broken\", line 1: ") == 0);
                    assertEquals("model \"refused\": it can't be added: no", _log[1]);
                    assertEquals("good", _log[2]);
                    assertEquals("good", _receiver.received.join());
                });
        }

        [Test(async, timeout="150000")]
        public function keepsToItsBudget():void
        {
            var progress:Array = [];
            _receiver.stepMs = 1;
            _loader.budget = 5;
            for (var i:int = 0; i < 12; i++)
            {
                _loader.loadText("model " + i, grid(20));
            }
            _loader.addEventListener(ProgressEvent.PROGRESS, function(event:ProgressEvent):void
                {
                    assertEquals(1200, event.bytesTotal);
                    assertTrue(progress.length == 0 || progress[progress.length - 1] <= event.bytesLoaded);
                    progress.push(event.bytesLoaded);
                });
            whenComplete(function():void
                {
                    trace("  12 models in " + progress.length + " frames, the longest " + _loader.longestFrame +
                            " ms of " + _loader.budget);
                    assertEquals(12, _receiver.received.length);
                    assertTrue("several frames: " + progress.length, progress.length > 3);
                    assertEquals(1200, progress.pop());
                });
        }

        [Test]
        public function cancelsAll():void
        {
            var cancelled:int = 0;
            _loader.addEventListener(Event.CANCEL, function(event:Event):void
                {
                    cancelled++;
                });
            _loader.load("file", "/fixtures/models/expected.json");
            _loader.loadText("text", OBJ);
            assertEquals(2, _loader.pendingCount);
            assertEquals("file,text", _receiver.expected.join());
            _loader.cancel("text");
            assertEquals(1, _loader.pendingCount);
            assertEquals("file", _receiver.expected.join());
            assertEquals(0, cancelled);
            _loader.cancel();
            assertEquals(0, _loader.pendingCount);
            assertEquals(0, _receiver.expected.length);
            assertEquals(1, cancelled);
        }

        /** A game that starts on COMPLETE starts with what there is. */
        [Test(async, timeout="150000")]
        public function isCompleteIfTheRestIsCancelled():void
        {
            var cancelled:int = 0;
            _loader.addEventListener(Event.CANCEL, function(event:Event):void
                {
                    cancelled++;
                });
            _loader.loadText("a", OBJ);
            _loader.load("b", "/fixtures/models/expected.json");
            _loader.addEventListener(ModelEvent.LOADED, function(event:ModelEvent):void
                {
                    _loader.cancel("b");
                });
            whenComplete(function():void
                {
                    assertEquals("a", _log.join());
                    assertEquals(0, cancelled);
                });
        }

        [Test(async, timeout="150000")]
        public function cancelsOneAmongOthers():void
        {
            _receiver.stepMs = 20;
            _loader.loadText("first", OBJ);
            _loader.loadText("second", OBJ);
            _loader.addEventListener(ProgressEvent.PROGRESS, function(event:ProgressEvent):void
                {
                    if (event.bytesLoaded >= 50)
                    {
                        _loader.cancel("first");
                    }
                });
            whenComplete(function():void
                {
                    assertEquals("second", _log.join());
                    assertEquals("second", _receiver.received.join());
                });
        }

        private function whenComplete(check:Function):void
        {
            Async.handleEvent(this, _loader, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals(0, _loader.pendingCount);
                    assertEquals(0, _receiver.expected.length);
                    check();
                }, 120000);
        }

        private static function grid(size:int):String
        {
            var lines:Array = [];
            for (var y:int = 0; y <= size; y++)
            {
                for (var x:int = 0; x <= size; x++)
                {
                    lines.push("v " + x + " " + y + " " + x * y % 7);
                }
            }
            for (y = 0; y < size; y++)
            {
                for (x = 1; x <= size; x++)
                {
                    var corner:int = y * (size + 1) + x;
                    lines.push("f " + corner + " " + (corner + 1) + " " + (corner + size + 2) + " " + (corner +
                                size + 1));
                }
            }
            return lines.join("\n");
        }
    }
}

import starlogo.models.BuiltInModel;
import starlogo.models.Model;
import starlogo.models.ModelMaker;

/** Makes a cube in some steps. */
class CountedMaker implements ModelMaker
{
    public var done:int = 0;

    private var _name:String;
    private var _steps:int;
    private var _isBroken:Boolean;

    public function CountedMaker(name:String, steps:int, isBroken:Boolean)
    {
        _name = name;
        _steps = steps;
        _isBroken = isBroken;
    }

    public function get name():String
    {
        return _name;
    }

    public function get progress():Number
    {
        return done / _steps;
    }

    public function get model():Model
    {
        var cube:Model = BuiltInModel.cube();
        return done < _steps ? null : new Model(_name, cube.vertices, cube.triangles);
    }

    public function step():Boolean
    {
        if (_isBroken)
        {
            throw new Error("no more");
        }
        return ++done < _steps;
    }
}
