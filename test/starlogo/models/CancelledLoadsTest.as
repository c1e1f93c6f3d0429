package starlogo.models
{
    import flash.events.Event;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import starlogo.steps.Steps;

    /** Loads that are cancelled while others are. It is the receiver itself. */
    public class CancelledLoadsTest implements ModelReceiver
    {
        private static const NAMES:Array = ["bear", "hasOwnProperty"];

        private var _loader:ModelLoader = null;
        private var _expected:int = 0;
        private var _cancels:Boolean = true;

        /** A receiver that hears of the end of one load may cancel the others. */
        [Test]
        public function cancelsWhileItCancels():void
        {
            _loader = new ModelLoader(this);
            for (var i:int = 0; i < 6; i++)
            {
                _loader.loadText(NAMES[i % 2], "v 0 0 0");
            }
            assertEquals(6, _expected);
            assertTrue(_loader.isPending("hasOwnProperty"));
            assertFalse("a member of every object", _loader.isPending("toString"));
            _loader.cancel(NAMES[0]);
            assertEquals(0, _expected);
            assertEquals(0, _loader.pendingCount);
            assertFalse(_loader.isPending(NAMES[1]));
        }

        /** All listeners hear of a model before the end, even if one of them cancels what is left. */
        [Test(async, timeout="150000")]
        public function theEndComesAfterWhatIsLoaded():void
        {
            var log:Array = [];
            _loader = new ModelLoader(this, 0);
            _cancels = false;
            _loader.addEventListener(ModelEvent.LOADED, function(event:ModelEvent):void
                {
                    log.push("a");
                    _loader.cancel();
                });
            _loader.addEventListener(ModelEvent.LOADED, function(event:ModelEvent):void
                {
                    log.push("b");
                });
            _loader.loadText(NAMES[0], "v 0 0 0");
            _loader.loadText(NAMES[1], "v 0 0 0");
            Async.handleEvent(this, _loader, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals("a,b", log.join());
                    assertEquals(0, _loader.pendingCount);
                }, 120000);
        }

        public function expect(name:String):void
        {
            _expected++;
        }

        public function expectNoMore(name:String, problem:String = null):void
        {
            _expected--;
            if (_cancels)
            {
                _loader.cancel();
            }
        }

        public function receive(model:Model):Steps
        {
            return null;
        }
    }
}
