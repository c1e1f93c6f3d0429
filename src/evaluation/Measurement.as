package evaluation
{
    import headless.Host;

    /** Something that is timed, and how long it took. */
    public final class Measurement
    {
        private static const SAMPLE_MS:int = 12;

        /** What is measured. */
        public var name:String;

        /** What the method does besides what is to be measured, measured in turn; its median is taken off. Or null. */
        public var overhead:Measurement;

        private var _method:Function;
        private var _count:Number;
        private var _repeats:int = 0;
        private var _times:Array = [];

        /**
         * @param name what is measured
         * @param method called without arguments
         * @param count how often it does the thing in one call; less than 1 where it does a part of it
         */
        public function Measurement(name:String, method:Function, count:Number)
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
            return samples.median;
        }

        /** How many times as long this takes as the base, in the same round each: the median. */
        public function timesAsLongAs(base:Measurement):Number
        {
            return multiplesOf(base).median;
        }

        /** The nanoseconds for one, as often as they were measured. */
        public function get samples():Samples
        {
            return new Samples(times());
        }

        /** How many times as long as the base this took, in each round. */
        public function multiplesOf(base:Measurement):Samples
        {
            var own:Array = times();
            var ratios:Array = [];
            for (var i:int = 0; i < own.length; i++)
            {
                ratios.push(own[i] / base._times[i]);
            }
            return new Samples(ratios);
        }

        /** Finds how often to call the method for a sample long enough for the clock; nothing of it counts. */
        public function warmUp():void
        {
            var start:Number = Host.now;
            // once at least: a busy machine may take all of the time away from it
            do
            {
                _method();
                _repeats++;
            }
            while (Host.now - start < SAMPLE_MS);
        }

        /** Takes one sample. */
        public function sample():void
        {
            var start:Number = Host.now;
            for (var i:int = 0; i < _repeats; i++)
            {
                _method();
            }
            _times.push((Host.now - start) * 1e6 / _count / _repeats);
        }

        private function times():Array
        {
            if (overhead == null)
            {
                return _times;
            }
            var less:Number = overhead.samples.median;
            var remaining:Array = [];
            for (var i:int = 0; i < _times.length; i++)
            {
                remaining.push(_times[i] - less);
            }
            return remaining;
        }
    }
}
