package evaluation
{
    /** Measures two waits on a clock of its own: one that is always as long, and one that a test makes longer. */
    public final class WaitingTask extends MeasuringTask
    {
        /** The wait that is always as long. */
        public var steady:Measurement;

        /** The wait that the test changes. */
        public var changing:Measurement;

        /** The length of the changing wait, in milliseconds. */
        public var ms:int = 1;

        private var _now:Number = 0;

        /**
         * @param settings says how often
         * @param results takes the times
         */
        public function WaitingTask(settings:Settings, results:Results)
        {
            super("waits", 1, settings, results);
        }

        /** The sphere-sphere test. */
        public function get base():Measurement
        {
            return _base;
        }

        /** @inheritDoc */
        override protected function prepare():void
        {
            steady = measure("steady", function():void
                {
                    wait(1);
                }, 1);
            changing = measure("changing", function():void
                {
                    wait(ms);
                }, 1);
        }

        /** @inheritDoc */
        override protected function conclude():Boolean
        {
            _results.addTime("tests", "waits", "steady", steady, _base);
            _results.addTime("tests", "waits", "changing", changing, _base);
            return true;
        }

        // Each look at the clock takes a moment too, so that a measurement of anything ends.
        override protected function readClock():Number
        {
            return _now += 0.5;
        }

        private function wait(ms:int):void
        {
            _now += ms;
        }
    }
}
