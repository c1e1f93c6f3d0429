package evaluation
{
    import flash.utils.getTimer;

    /** Measures two waits: one that is always as long, and one that a test makes longer. */
    public final class WaitingTask extends MeasuringTask
    {
        /** The wait that is always as long. */
        public var steady:Measurement;

        /** The wait that the test changes. */
        public var changing:Measurement;

        /** The length of the changing wait, in milliseconds. */
        public var ms:int = 1;

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

        private static function wait(ms:int):void
        {
            var end:int = getTimer() + ms;
            var now:int = end - ms;
            while (now < end)
            {
                now = getTimer();
            }
        }
    }
}
