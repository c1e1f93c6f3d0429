package evaluation
{
    import headless.Host;

    /** A method that is timed, and its times. */
    public final class Measurement
    {
        private static const SAMPLE_MS:int = 12;

        /** The name of the thing that is measured. */
        public var name:String;

        /** Measures the part of the method that should not count; its median is subtracted. Null for none. */
        public var overhead:Measurement;

        private var _method:Function;
        private var _count:Number;
        private var _clock:Function;
        private var _repeats:int = 0;
        private var _times:Array = [];

        /**
         * @param name the name of the thing that is measured
         * @param method called without arguments
         * @param count how often one call does the thing; less than 1 if it does only a part of it
         * @param clock <code>():Number</code>, milliseconds since some fixed moment; null for the host's clock
         */
        public function Measurement(name:String, method:Function, count:Number, clock:Function = null)
        {
            this.name = name;
            _method = method;
            _count = count;
            _clock = clock == null ? hostClock : clock;
        }

        /** Measures all, after a warm-up. The measurements take turns, so that a slow moment of the machine affects all of them equally. */
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

        /** The median, in nanoseconds for one thing. */
        public function get nanoseconds():Number
        {
            return samples.median;
        }

        /** The median, in milliseconds, as text. */
        public function get ms():String
        {
            return (nanoseconds / 1e6).toFixed(2);
        }

        /** How many times as long this takes as the base in the same round: the median of all rounds. */
        public function timesAsLongAs(base:Measurement):Number
        {
            return multiplesOf(base).median;
        }

        /** The nanoseconds for one thing, in each round. */
        public function get samples():Samples
        {
            return new Samples(times());
        }

        /** How many times as long this took as the base, in each round. */
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

        /** Finds how many calls make a sample that is long enough for the clock. These calls do not count. */
        public function warmUp():void
        {
            var start:Number = _clock();
            // At least once, because a busy machine may use up all of the time.
            do
            {
                _method();
                _repeats++;
            }
            while (_clock() - start < SAMPLE_MS);
        }

        /** Takes one sample. */
        public function sample():void
        {
            var start:Number = _clock();
            for (var i:int = 0; i < _repeats; i++)
            {
                _method();
            }
            _times.push((_clock() - start) * 1e6 / _count / _repeats);
        }

        /** Forgets the samples. */
        public function forget():void
        {
            _times.length = 0;
        }

        private static function hostClock():Number
        {
            return Host.now;
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
