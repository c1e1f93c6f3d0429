package flash.utils
{
    import flash.events.EventDispatcher;
    import flash.events.TimerEvent;
    import standin.Machine;

    /** Sends a TimerEvent again and again, after a delay each time. */
    public class Timer extends EventDispatcher
    {
        private var _delay:Number;
        private var _repeatCount:int;
        private var _currentCount:int = 0;
        private var _isRunning:Boolean = false;
        private var _pending:uint;

        /**
         * @param delay milliseconds
         * @param repeatCount the number of events; 0 means until it is stopped
         * @throws RangeError if the delay is negative or not finite
         */
        public function Timer(delay:Number, repeatCount:int = 0)
        {
            checkDelay(delay);
            _delay = delay;
            _repeatCount = repeatCount;
        }

        public function get delay():Number
        {
            return _delay;
        }

        public function get running():Boolean
        {
            return _isRunning;
        }

        public function start():void
        {
            if (!_isRunning)
            {
                _isRunning = true;
                _pending = Machine.setTimeout(ring, _delay);
            }
        }

        public function stop():void
        {
            if (_isRunning)
            {
                _isRunning = false;
                Machine.clearTimeout(_pending);
            }
        }

        public function reset():void
        {
            stop();
            _currentCount = 0;
        }

        private function ring():void
        {
            _currentCount++;
            _pending = Machine.setTimeout(ring, _delay);
            dispatchEvent(new TimerEvent(TimerEvent.TIMER));
            if (_isRunning && _repeatCount != 0 && _currentCount >= _repeatCount)
            {
                stop();
                dispatchEvent(new TimerEvent(TimerEvent.TIMER_COMPLETE));
            }
        }

        private static function checkDelay(delay:Number):void
        {
            if (!(delay >= 0 && delay < Infinity))
            {
                throw new RangeError("Error #2066: The Timer delay specified is out of range.");
            }
        }
    }
}
