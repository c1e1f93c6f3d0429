package evaluation
{
    import headless.Host;

    /** What was measured: entries as docs/timing-report.md describes them. */
    public final class Results
    {
        private static const NS_PER_MS:Number = 1e6;

        private var _entries:Array = [];
        private var _failures:int = 0;

        /** How many checks failed. */
        public function get failures():int
        {
            return _failures;
        }

        /**
         * Adds a plain number.
         *
         * @param figure what it belongs to
         * @param subject the row
         * @param variant the column
         * @param value the number
         * @param unit of the number
         * @param thesis the thesis's number, or undefined
         * @return the entry
         */
        public function addNumber(figure:String, subject:String, variant:String, value:Number, unit:String, thesis:* = undefined):Object
        {
            var entry:Object = {figure: figure, subject: subject, variant: variant, unit: unit, value: value};
            if (thesis !== undefined)
            {
                entry.thesis = thesis;
            }
            _entries.push(entry);
            return entry;
        }

        /**
         * Adds a time in milliseconds, and as a multiple of the sphere-sphere test; or why it is not reported.
         *
         * @param figure what it belongs to
         * @param subject the row
         * @param variant the column
         * @param measurement what was measured
         * @param base the sphere-sphere test, measured in the same rounds
         * @param thesis the thesis's milliseconds, or undefined
         * @return the entry
         */
        public function addTime(figure:String, subject:String, variant:String, measurement:Measurement, base:Measurement, thesis:* = undefined):Object
        {
            var times:Samples = measurement.samples;
            var entry:Object = addNumber(figure, subject, variant, times.median / NS_PER_MS, "ms", thesis);
            entry.low = times.low / NS_PER_MS;
            entry.high = times.high / NS_PER_MS;
            entry.samples = times.count;
            var multiples:Samples = measurement.multiplesOf(base);
            entry.multiple = multiples.median;
            entry.multipleLow = multiples.low;
            entry.multipleHigh = multiples.high;
            if (!times.isSteady)
            {
                entry.value = entry.multiple = null;
                entry.refused = times.median > 0 ? "±" + Math.round(times.spread * 100) + " %, noisy" : "too short for the clock";
            }
            return entry;
        }

        /** Notes whether the collisions of an entry are those that all pairs have. */
        public function check(entry:Object, collisions:int, agrees:Boolean):void
        {
            entry.collisions = collisions;
            entry.agrees = agrees;
            if (!agrees)
            {
                _failures++;
            }
        }

        /** All of it as JSON. */
        public function toText():String
        {
            return JSON.stringify({player: Host.player, entries: _entries}, null, 1);
        }
    }
}
