package support
{
    import flash.display.Shape;
    import flash.events.Event;
    import flash.events.EventDispatcher;
    import org.flexunit.async.Async;
    import starlogo.steps.Steps;

    /** A test's long work, some steps a frame: between frames players collect what was let go of. */
    public final class FrameByFrame extends EventDispatcher
    {
        private static const TIMEOUT:int = 890000;

        private var _work:Steps;
        private var _stepsAFrame:int;
        private var _error:Error = null;
        private var _shape:Shape = new Shape();

        /**
         * Begins.
         *
         * @param test the test's object; the test is asynchronous, with a timeout of 900,000 ms
         * @param work what to do; an error that a step throws fails the test
         * @param stepsAFrame how many of its steps
         * @param end called when no step is left: <code>function():void</code>
         */
        public static function run(test:Object, work:Steps, stepsAFrame:int, end:Function):void
        {
            var running:FrameByFrame = new FrameByFrame(work, stepsAFrame);
            Async.handleEvent(test, running, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    running.throwError();
                    end();
                }, TIMEOUT);
        }

        /**
         * @param work what to do
         * @param stepsAFrame how many of its steps
         */
        public function FrameByFrame(work:Steps, stepsAFrame:int)
        {
            _work = work;
            _stepsAFrame = stepsAFrame;
            _shape.addEventListener(Event.ENTER_FRAME, onFrame);
        }

        private function onFrame(event:Event):void
        {
            var hasMore:Boolean = true;
            try
            {
                for (var i:int = 0; i < _stepsAFrame && hasMore; i++)
                {
                    hasMore = _work.step();
                }
            }
            catch (error:Error)
            {
                _error = error;
                hasMore = false;
            }
            if (!hasMore)
            {
                _shape.removeEventListener(Event.ENTER_FRAME, onFrame);
                dispatchEvent(new Event(Event.COMPLETE));
            }
        }

        private function throwError():void
        {
            if (_error != null)
            {
                throw _error;
            }
        }
    }
}
