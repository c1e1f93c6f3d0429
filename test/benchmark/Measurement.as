package benchmark
{
    import flash.utils.getTimer;

    /** Something that is timed, and how long it took. */
    public final class Measurement
    {
        private static const SAMPLE_MS:int = 30;

        /** What is measured. */
        public var name:String;

        private var _method:Function;
        private var _count:int;
        private var _repeats:int = 0;
        private var _times:Array = [];

        /**
         * @param name what is measured
         * @param method called without arguments
         * @param count how often it does the thing in one call
         */
        public function Measurement(name:String, method:Function, count:int)
        {
            this.name = name;
            _method = method;
            _count = count;
        }

        /** Measures all of them after a warm-up, taking turns so that a slow moment of the machine hits them alike. */
        public static function runAll(measurements:Vector.<Measurement>, rounds:int):void
        {
            for (var i:int = 0; i < measurements.length; i++)
            {
                measurements[i].warmUp();
            }
            for (var round:int = 0; round < rounds; round++)
            {
                for (i = 0; i < measurements.length; i++)
                {
                    measurements[i].sample();
                }
            }
        }

        /** The median, in nanoseconds for one. */
        public function get nanoseconds():Number
        {
            return medianOf(_times);
        }

        /** How many times as long this takes as the base, in the same round each: the median. */
        public function timesAsLongAs(base:Measurement):Number
        {
            var ratios:Array = [];
            for (var i:int = 0; i < _times.length; i++)
            {
                ratios.push(_times[i] / base._times[i]);
            }
            return medianOf(ratios);
        }

        private static function medianOf(values:Array):Number
        {
            var sorted:Array = values.concat();
            sorted.sort(Array.NUMERIC);
            return sorted[int(sorted.length / 2)];
        }

        /** Finds how often to call the method for a sample that the millisecond clock resolves. */
        private function warmUp():void
        {
            var start:int = getTimer();
            while (getTimer() - start < SAMPLE_MS)
            {
                _method();
                _repeats++;
            }
        }

        private function sample():void
        {
            var start:int = getTimer();
            for (var i:int = 0; i < _repeats; i++)
            {
                _method();
            }
            _times.push((getTimer() - start) * 1e6 / _count / _repeats);
        }
    }
}
