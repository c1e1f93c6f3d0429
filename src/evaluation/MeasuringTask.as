package evaluation
{
    import evaluation.pairs.PairLoops;
    import evaluation.pairs.PairSet;
    import headless.Host;
    import starlogo.bounding.BoundingStructure;

    /**
     * Measures some things in turns with the sphere-sphere test, after a warm-up that does not count. If the samples of one, or its multiples
     * of that test, differ too much, it takes up to three times as many of this one, unless they have taken seconds. A thing that takes seconds is repeated less often.
     */
    public class MeasuringTask extends Task
    {
        private static const SEED:uint = 31;
        private static const HITS:Number = 0.4;
        private static const MAX_TIMES:int = 3;
        private static const LONG_MS:Number = 2500;
        private static const LONGEST_MS:Number = 5000;

        private static var sBasePairs:PairLoops;

        /** Takes the measurements. */
        protected var _results:Results;

        /** The sphere-sphere test. */
        protected var _base:Measurement;

        private var _repetitions:int;
        private var _longRepetitions:int;
        private var _measurements:Vector.<Measurement> = new Vector.<Measurement>();
        private var _overheads:Vector.<Measurement> = new Vector.<Measurement>();
        // those that the present round takes
        private var _active:Vector.<Measurement>;
        private var _isPrepared:Boolean = false;
        private var _warm:int = 0;
        private var _next:int = 0;
        private var _rounds:int = 0;
        private var _spent:Number = 0;

        /**
         * For subclasses.
         *
         * @param title the task's title
         * @param weight how long it takes
         * @param settings says how often things are measured
         * @param results takes the measurements
         */
        public function MeasuringTask(title:String, weight:Number, settings:Settings, results:Results)
        {
            super(title, weight);
            _repetitions = settings.repetitions;
            _longRepetitions = settings.longRepetitions;
            _results = results;
        }

        /** @inheritDoc */
        override public function work():Boolean
        {
            if (!_isPrepared)
            {
                _isPrepared = true;
                sBasePairs ||= new PairLoops(new PairSet(BoundingStructure.SPHERE, BoundingStructure.SPHERE, HITS, SEED));
                _base = measure("sphere-sphere", sBasePairs.sphereSpherePairs, PairSet.COUNT);
                prepare();
                return false;
            }
            if (_warm < _measurements.length)
            {
                _measurements[_warm++].warmUp();
                return false;
            }
            _active ||= _measurements;
            if (!areEnough())
            {
                sampleNext();
                return false;
            }
            return conclude();
        }

        /** Whether samples of a measurement, or its multiples, differ too much. */
        public function get isNoisy():Boolean
        {
            return noisyOf(_measurements).length > 0;
        }

        /** Begins once more with the measurements whose samples differ too much. */
        public function repeatNoisy():void
        {
            _active = withBase(noisyOf(_measurements));
            for each (var measurement:Measurement in _active)
            {
                measurement.forget();
            }
            _rounds = 0;
            _spent = 0;
        }

        /** Creates the measurements. */
        protected function prepare():void
        {
        }

        /** Milliseconds since some fixed moment. The measurements take their times from it. */
        protected function readClock():Number
        {
            return Host.now;
        }

        /** Puts the measurements into the results. It is called again until it returns true. */
        protected function conclude():Boolean
        {
            return true;
        }

        /** Adds a measurement that is only subtracted from another one. Its samples may differ much. */
        protected function measureOverhead(of:Measurement, name:String, method:Function, count:Number):void
        {
            of.overhead = measure(name, method, count);
            _overheads.push(of.overhead);
        }

        /** Adds a measurement. */
        protected function measure(name:String, method:Function, count:Number):Measurement
        {
            var measurement:Measurement = new Measurement(name, method, count, readClock);
            _measurements.push(measurement);
            return measurement;
        }

        private function sampleNext():void
        {
            var start:Number = readClock();
            _active[_next++].sample();
            _spent += readClock() - start;
            if (_next == _active.length)
            {
                _next = 0;
                _rounds++;
            }
        }

        // After the wanted rounds, those whose samples are close together are done.
        private function areEnough():Boolean
        {
            var wanted:int = _spent < LONG_MS ? _repetitions : _longRepetitions;
            if (_next != 0 || _rounds < wanted)
            {
                return false;
            }
            var noisy:Vector.<Measurement> = noisyOf(_active);
            _active = withBase(noisy);
            return noisy.length == 0 || _rounds >= MAX_TIMES * wanted || _spent > LONGEST_MS;
        }

        private function noisyOf(measurements:Vector.<Measurement>):Vector.<Measurement>
        {
            var noisy:Vector.<Measurement> = new Vector.<Measurement>();
            for each (var measurement:Measurement in measurements)
            {
                if (_overheads.indexOf(measurement) < 0 && !(measurement.samples.isSteady && measurement.multiplesOf(_base).isSteady))
                {
                    noisy.push(measurement);
                }
            }
            return noisy;
        }

        // These measurements with what they need in each round: the sphere-sphere test first, and their overheads.
        private function withBase(measurements:Vector.<Measurement>):Vector.<Measurement>
        {
            var all:Vector.<Measurement> = new <Measurement>[_base];
            for each (var measurement:Measurement in measurements)
            {
                if (measurement.overhead != null)
                {
                    all.push(measurement.overhead);
                }
                if (measurement !== _base)
                {
                    all.push(measurement);
                }
            }
            return all;
        }
    }
}
