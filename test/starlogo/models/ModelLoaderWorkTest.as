package starlogo.models
{
    import flash.display.Shape;
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.EventDispatcher;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNotNull;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import support.RecordingURLLoader;
    import support.assertThrows;
    import support.assign;
    import support.create;
    import support.encoded;
    import support.whenComplete;

    /** How a ModelLoader lives and works: its frames, its clock, its fetching. It is its receiver itself. */
    public class ModelLoaderWorkTest implements ModelReceiver
    {
        private static const OBJ:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
        private static const STEPS:int = 40;
        private static const BUDGET:int = 10;

        private var _log:Array = [];
        private var _frames:Shape = new Shape();
        private var _frameCount:int = 0;
        private var _done:EventDispatcher = new EventDispatcher();
        private var _garbage:Array;
        private var _loader:TestedLoader = null;

        [After]
        public function tearDown():void
        {
            _frames.removeEventListener(Event.ENTER_FRAME, onFrame);
            _garbage = null;
            if (_loader != null)
            {
                _loader.cancel();
            }
        }

        [Test(async, timeout="150000")]
        public function livesWhileItHasWork():void
        {
            beginWithoutKeeping();
            assertTrue(ModelLoader.sFrames.hasEventListener(Event.ENTER_FRAME));
            _frames.addEventListener(Event.ENTER_FRAME, onFrame);
            Async.handleEvent(this, _done, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals("loaded text,the receiver hears: model \"file\",model \"file\": no vertices, so this is no OBJ text,complete", _log.join());
                    assertFalse("nothing holds it any more", ModelLoader.sFrames.hasEventListener(Event.ENTER_FRAME));
                }, 120000);
        }

        /** As a game does that listens, and keeps no reference. */
        private function beginWithoutKeeping():void
        {
            var loader:ModelLoader = new ModelLoader(this, 0);
            loader.addEventListener(ModelEvent.LOADED, function(event:ModelEvent):void
                {
                    _log.push("loaded " + event.model.name);
                });
            loader.addEventListener(ErrorEvent.ERROR, function(event:ErrorEvent):void
                {
                    _log.push(event.text.split(": expected")[0]);
                });
            loader.addEventListener(Event.COMPLETE, function(event:Event):void
                {
                    _log.push("complete");
                });
            loader.loadText("text", OBJ);
            loader.load("file", "/fixtures/models/expected.json");
        }

        // makes garbage, so that the player collects it
        private function onFrame(event:Event):void
        {
            _garbage = [];
            for (var i:int = 0; i < 20000; i++)
            {
                _garbage.push(new <Number>[i, i, i]);
            }
            _frameCount++;
            if (_log.indexOf("complete") >= 0 || _frameCount == 3 * STEPS)
            {
                _done.dispatchEvent(new Event(Event.COMPLETE));
            }
        }

        [Test]
        public function nothingHoldsItWhenAllIsCancelled():void
        {
            _loader = new TestedLoader(this, BUDGET);
            assertFalse(ModelLoader.sFrames.hasEventListener(Event.ENTER_FRAME));
            _loader.loadText("a", OBJ);
            _loader.loadText("b", OBJ);
            assertTrue(ModelLoader.sFrames.hasEventListener(Event.ENTER_FRAME));
            _loader.cancel("a");
            assertTrue(ModelLoader.sFrames.hasEventListener(Event.ENTER_FRAME));
            _loader.cancel("b");
            assertFalse(ModelLoader.sFrames.hasEventListener(Event.ENTER_FRAME));
        }

        [Test]
        public function refusesWhatItCannotWorkWith():void
        {
            assertThrows(ArgumentError, /receiver/, create, ModelLoader, null, 8);
            assertThrows(RangeError, /-1/, create, ModelLoader, this, -1);
            assertThrows(RangeError, /NaN/, create, ModelLoader, this, NaN);
            var loader:ModelLoader = new ModelLoader(this);
            loader.budget = Infinity;
            assertThrows(RangeError, /budget.*-0\.5/, assign, loader, "budget", -0.5);
            assertEquals(Infinity, loader.budget);
        }

        [Test]
        public function cancelStopsFetching():void
        {
            _loader = new TestedLoader(this, BUDGET);
            _loader.load("a", "a.obj");
            _loader.load("b", "b.obj");
            var a:RecordingURLLoader = _loader.fetches[0];
            var b:RecordingURLLoader = _loader.fetches[1];
            assertEquals("a.obj", a.addresses.join());
            assertTrue(a.hasEventListener(Event.COMPLETE));
            _loader.cancel("a");
            assertEquals(1, a.closeCount);
            assertFalse("nothing arrives any more", a.hasEventListener(Event.COMPLETE));
            assertEquals("the other one goes on", 0, b.closeCount);
            b.deliver(encoded(OBJ));
            _loader.cancel();
            assertEquals("one that is fetched is not closed", 0, b.closeCount);
            assertEquals(1, a.closeCount);
        }

        [Test(async, timeout="150000")]
        public function whatWasCancelledDoesNotArrive():void
        {
            _loader = new TestedLoader(this, BUDGET);
            _loader.addEventListener(ModelEvent.LOADED, function(event:ModelEvent):void
                {
                    _log.push(event.model.name);
                });
            _loader.load("a", "a.obj");
            _loader.load("a", "again.obj");
            _loader.load("b", "b.obj");
            _loader.cancel("a");
            for each (var fetch:RecordingURLLoader in _loader.fetches)
            {
                fetch.deliver(encoded(OBJ));
            }
            whenComplete(this, _loader, function():void
                {
                    assertEquals("b", _log.join());
                });
        }

        [Test(async, timeout="150000")]
        public function beginsNoStepWhenItsBudgetIsSpent():void
        {
            _loader = new TestedLoader(this, BUDGET);
            for (var i:int = 0; i < 12; i++)
            {
                _loader.loadText("model " + i, OBJ);
            }
            whenComplete(this, _loader, function():void
                {
                    assertTrue("many steps: " + _loader.stepCount, _loader.stepCount > 12 * STEPS);
                    assertTrue("several a frame: " + _loader.frameCount, _loader.frameCount < _loader.stepCount / 2);
                    assertEquals("steps begun when the budget was spent", 0, _loader.lateStepCount);
                    assertTrue("it works until then, but for the last frame", _loader.shortFrameCount <= 1);
                });
        }

        [Test(async, timeout="150000")]
        public function doesOneStepAFrameWithoutABudget():void
        {
            _loader = new TestedLoader(this, 0);
            _loader.loadText("model", OBJ);
            whenComplete(this, _loader, function():void
                {
                    assertTrue("many steps: " + _loader.stepCount, _loader.stepCount > STEPS);
                    assertEquals(_loader.stepCount, _loader.frameCount);
                });
        }

        /** @inheritDoc */
        public function expect(name:String):void
        {
        }

        /** @inheritDoc */
        public function expectNoMore(name:String, problem:String = null):void
        {
            if (problem != null)
            {
                _log.push("the receiver hears: " + problem.split(":")[0]);
            }
        }

        /** @inheritDoc */
        public function receive(model:Model):Steps
        {
            assertNotNull(model);
            var work:StepSequence = new StepSequence();
            for (var i:int = 0; i < STEPS; i++)
            {
                work.call(doNothing);
            }
            return work;
        }

        private static function doNothing():void
        {
        }
    }
}
