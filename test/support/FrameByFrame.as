package support
{
    import flash.display.Shape;
    import flash.events.Event;
    import flash.events.EventDispatcher;
    import org.flexunit.async.Async;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** A test's long work, some steps a frame: between frames players collect what was let go of. */
    public final class FrameByFrame extends EventDispatcher
    {
        private static const TIMEOUT:int = 3590000;
        private static const ROUNDS_A_FRAME:int = 50;

        private var _work:Steps;
        private var _stepsAFrame:int;
        private var _error:Error = null;
        private var _shape:Shape = new Shape();

        /**
         * Begins.
         *
         * @param test the test's object; the test is asynchronous, with a timeout of 3,600,000 ms
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
         * Begins rounds of a test that tries many cases.
         *
         * @param test the test's object; the test is asynchronous, with a timeout of 3,600,000 ms
         * @param count how many rounds, at least one
         * @param round one of them: <code>function(i:int):void</code>; an error that it throws fails the test
         * @param end called after the last: <code>function():void</code>
         */
        public static function repeat(test:Object, count:int, round:Function, end:Function):void
        {
            var i:int = 0;
            run(test, new StepSequence().repeat(function():Boolean
                    {
                        round(i);
                        return ++i < count;
                    }), ROUNDS_A_FRAME, end);
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
