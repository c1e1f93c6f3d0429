package evaluation
{
    import evaluation.pairs.PairLoops;
    import evaluation.pairs.PairSet;
    import headless.Host;
    import starlogo.bounding.BoundingStructure;

    /**
     * Measures some things in turns with the sphere-sphere test, after a warm-up that does not count. If the samples differ too much, it
     * takes up to three times as many. A thing that takes seconds is repeated less often.
     */
    public class MeasuringTask extends Task
    {
        private static const SEED:uint = 31;
        private static const HITS:Number = 0.4;
        private static const MOST_TIMES:int = 3;
        private static const LONG_MS:Number = 2500;

        private static var sBasePairs:PairLoops;

        /** Takes the measurements. */
        protected var _results:Results;

        /** The sphere-sphere test. */
        protected var _base:Measurement;

        private var _repetitions:int;
        private var _longRepetitions:int;
        private var _measurements:Vector.<Measurement> = new Vector.<Measurement>();
        private var _overheads:Vector.<Measurement> = new Vector.<Measurement>();
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
            if (!areEnough())
            {
                sampleNext();
                return false;
            }
            return conclude();
        }

        /** Creates the measurements. */
        protected function prepare():void
        {
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
            var measurement:Measurement = new Measurement(name, method, count);
            _measurements.push(measurement);
            return measurement;
        }

        private function sampleNext():void
        {
            var start:Number = Host.now;
            _measurements[_next++].sample();
            _spent += Host.now - start;
            if (_next == _measurements.length)
            {
                _next = 0;
                _rounds++;
            }
        }

        private function areEnough():Boolean
        {
            var wanted:int = _spent < LONG_MS ? _repetitions : _longRepetitions;
            if (_next != 0 || _rounds < wanted)
            {
                return false;
            }
            return _rounds >= MOST_TIMES * wanted || areSteady();
        }

        private function areSteady():Boolean
        {
            for (var i:int = 0; i < _measurements.length; i++)
            {
                if (_overheads.indexOf(_measurements[i]) < 0 && !_measurements[i].samples.isSteady)
                {
                    return false;
                }
            }
            return true;
        }
    }
}
