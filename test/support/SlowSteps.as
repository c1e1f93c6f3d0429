package support
{
    import flash.utils.getTimer;
    import starlogo.steps.Steps;

    /** The steps of a SlowReceiver. */
    public class SlowSteps implements Steps
    {
        private var _receiver:SlowReceiver;
        private var _name:String;
        private var _isRefused:Boolean;
        private var _left:int = 10;

        public function SlowSteps(receiver:SlowReceiver, name:String, isRefused:Boolean)
        {
            _receiver = receiver;
            _name = name;
            _isRefused = isRefused;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            var start:int = getTimer();
            var now:int = start;
            while (now - start < _receiver.stepMs)
            {
                now = getTimer();
            }
            _left--;
            if (_left == 5 && _isRefused)
            {
                throw new ArgumentError("no");
            }
            if (_left == 0)
            {
                _receiver.received.push(_name);
            }
            return _left > 0;
        }
    }
}
