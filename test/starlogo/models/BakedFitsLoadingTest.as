package starlogo.models
{
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.IOErrorEvent;
    import flash.events.ProgressEvent;
    import flash.utils.ByteArray;
    import flash.utils.getTimer;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import starlogo.GreatLand;
    import support.CountingFitter;
    import support.LibraryContents;
    import support.SlowReceiver;
    import support.SteppedModels;

    /** A ModelLoader and the .fits files beside models. */
    public class BakedFitsLoadingTest
    {
        public static const FIXTURES:Array = SteppedModels.FIXTURES;

        private static const BUDGET:int = 8;
        private static const OBJ:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.2 0.3 1\nf 1 2 3\nf 1 2 4\n";

        private var _greatLand:GreatLand;
        private var _loader:TestedLoader;
        private var _fitter:CountingFitter;
        private var _errors:Array;

        [Before]
        public function setUp():void
        {
            _fitter = new CountingFitter();
            _greatLand = newGame();
            _errors = [];
            _loader = new TestedLoader(_greatLand, 1000);
            _loader.addEventListener(ErrorEvent.ERROR, function(event:ErrorEvent):void
                {
                    _errors.push(event.text);
                });
        }

        [After]
        public function tearDown():void
        {
            _loader.cancel();
        }

        [Test]
        public function whereItIsLookedFor():void
        {
            for each (var pair:Array in [["bear.obj", "bear.obj.fits"], ["a/b.dae?v=2#x", "a/b.dae.fits?v=2#x"], ["http://h/c.obj", "http://h/c.obj.fits"]])
            {
                _loader.load("bear", pair[0]);
                assertEquals(pair[1], _loader.fitsFetches.pop().addresses.join());
            }
            for each (var address:String in ["data:text/plain,v", "blob:http://h/123", "", null])
            {
                _loader.load("bear", address);
                assertEquals(address, "", _loader.fitsFetches.pop().addresses.join());
            }
        }

        [Test]
        public function whoDoesNotTakeItIsNotAsked():void
        {
            _loader.usesBakedFits = false;
            _loader.load("bear", "bear.obj");
            _loader.usesBakedFits = true;
            _loader.loadText("bear", OBJ);
            assertEquals(0, _loader.fitsFetches.length);
            var plain:TestedLoader = new TestedLoader(new SlowReceiver(1), 8);
            plain.load("bear", "bear.obj");
            assertEquals(0, plain.fitsFetches.length);
            plain.cancel();
        }

        [Test(async, timeout="10000")]
        public function whatIsBakedIsNotComputed():void
        {
            var other:GreatLand = newGame();
            other.addModel(new ObjModel("bear", OBJ));
            var baked:ByteArray = newGame().bake(new ObjModel("bear", OBJ));
            _fitter.count = 0;
            _loader.load("bear", "bear.obj");
            _loader.fetches[0].deliver(bytes(OBJ));
            _loader.fitsFetches[0].deliver(baked);
            whenComplete(function():void
                {
                    assertEquals("nothing is fitted", 0, _fitter.count);
                    assertEquals(LibraryContents.of(other, "bear"), LibraryContents.of(_greatLand, "bear"));
                });
        }

        [Test(async, timeout="60000")]
        public function aGamesModelsKeepToTheBudget():void
        {
            var files:Object = {};
            for each (var model:Model in SteppedModels.twelve())
            {
                for each (var file:String in SteppedModels.FIXTURES)
                {
                    if (SteppedModels.nameOf(file) == model.name)
                    {
                        files[file + ".fits"] = _greatLand.bake(model);
                    }
                }
            }
            _fitter.count = 0;
            var loader:ModelLoader = new OfferingLoader(_greatLand, BUDGET, files);
            for each (file in SteppedModels.FIXTURES)
            {
                loader.load(SteppedModels.nameOf(file), file);
            }
            var frames:int = 0;
            loader.addEventListener(ProgressEvent.PROGRESS, function(event:ProgressEvent):void
                {
                    frames++;
                });
            Async.handleEvent(this, loader, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    trace("  nine models with .fits files in " + frames + " frames: the longest " + loader.longestFrame + " ms of " + BUDGET
                            + ", the longest step " + loader.longestStep + " ms");
                    assertEquals("nothing is fitted", 0, _fitter.count);
                    assertTrue(_greatLand.hasModel("dragon") && _greatLand.hasModel("kelp"));
                    assertTrue("it stops when the budget is spent", loader.longestFrame <= BUDGET + loader.longestStep);
                }, 60000);
        }

        [Test(async, timeout="10000")]
        public function whereThereIsNoneItIsComputed():void
        {
            _loader.load("bear", "bear.obj");
            _loader.fetches[0].deliver(bytes(OBJ));
            _loader.fitsFetches[0].dispatchEvent(new IOErrorEvent(IOErrorEvent.IO_ERROR, false, false, "404"));
            whenComplete(assertComputedWithoutError);
        }

        [Test(async, timeout="10000")]
        public function whatIsSomethingElseIsNoError():void
        {
            _loader.load("bear", "bear.obj");
            _loader.fitsFetches[0].deliver(bytes("<html><body>This page was not found</body></html>"));
            _loader.fetches[0].deliver(bytes(OBJ));
            whenComplete(assertComputedWithoutError);
        }

        [Test(async, timeout="20000")]
        public function oneThatDoesNotComeIsNotWaitedForLong():void
        {
            var start:int = getTimer();
            _loader.load("bear", "bear.obj");
            _loader.fetches[0].deliver(bytes(OBJ));
            _loader.loadText("cube", OBJ);
            _loader.addEventListener(ModelEvent.LOADED, function(event:ModelEvent):void
                {
                    assertTrue("the others go on", event.model.name == "cube" || _greatLand.hasModel("cube"));
                });
            whenComplete(function():void
                {
                    assertTrue("it waited", getTimer() - start > 1900);
                    assertEquals("then it asked no more", 1, _loader.fitsFetches[0].closeCount);
                    assertComputedWithoutError();
                });
        }

        [Test]
        public function cancellingCancelsBoth():void
        {
            _loader.load("bear", "bear.obj");
            _loader.cancel("bear");
            assertEquals(1, _loader.fetches[0].closeCount);
            assertEquals(1, _loader.fitsFetches[0].closeCount);
            _loader.fitsFetches[0].deliver(bytes(OBJ));
            assertFalse(_greatLand.hasModel("bear"));
        }

        private function assertComputedWithoutError():void
        {
            assertTrue(_fitter.count > 0);
            assertEquals("", _errors.join());
            assertTrue(_greatLand.boundingStructures.has("bear") && _greatLand.hierarchies.has("bear"));
        }

        private function newGame():GreatLand
        {
            var game:GreatLand = new GreatLand();
            game.boundingStructures.fitters.push(_fitter);
            return game;
        }

        private function whenComplete(check:Function):void
        {
            Async.handleEvent(this, _loader, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    check();
                }, 15000);
        }

        private static function bytes(text:String):ByteArray
        {
            var all:ByteArray = new ByteArray();
            all.writeUTFBytes(text);
            all.position = 0;
            return all;
        }
    }
}
