package evaluation
{
    import headless.Host;

    /** The measurements, as entries that docs/timing-report.md describes. */
    public final class Results
    {
        private static const NS_PER_MS:Number = 1e6;

        /** What the report says of the run's settings. */
        public var settings:Object = {};

        private var _entries:Array = [];
        private var _byName:Object = {};

        /** The number of games whose collisions were not those of all pairs. */
        public function get failures():int
        {
            return _entries.filter(hasDiffered).length;
        }

        /**
         * Adds a plain number. An entry that has a value keeps it: then this is a measurement that was repeated for another entry.
         *
         * @param figure the entry's figure
         * @param subject the entry's row
         * @param variant the entry's column
         * @param value the number
         * @param unit the number's unit
         * @param thesis the thesis's number, or undefined
         * @return the entry
         */
        public function addNumber(figure:String, subject:String, variant:String, value:Number, unit:String, thesis:* = undefined):Object
        {
            var name:String = nameOf(figure, subject, variant);
            var entry:Object = _byName[name];
            if (entry != null && entry.value != null)
            {
                return entry;
            }
            if (entry == null)
            {
                entry = _byName[name] = {figure: figure, subject: subject, variant: variant, unit: unit};
                _entries.push(entry);
            }
            entry.value = value;
            if (thesis !== undefined)
            {
                entry.thesis = thesis;
            }
            return entry;
        }

        /**
         * Adds a time in milliseconds, and as a multiple of the sphere-sphere test. Each is judged by its own range. If the times say nothing, the
         * entry gets the reason, and no number. If only the multiples say nothing, it gets no multiple. An entry that lacks a multiple takes
         * later measurements if these have both, and other entries that have a value keep it.
         *
         * @param figure the entry's figure
         * @param subject the entry's row
         * @param variant the entry's column
         * @param measurement the measurement
         * @param base the sphere-sphere test, measured in the same rounds
         * @param thesis the thesis's milliseconds, or undefined
         * @return the entry
         */
        public function addTime(figure:String, subject:String, variant:String, measurement:Measurement, base:Measurement, thesis:* = undefined):Object
        {
            var known:Object = _byName[nameOf(figure, subject, variant)];
            var times:Samples = measurement.samples;
            var multiples:Samples = measurement.multiplesOf(base);
            if (known != null && known.value != null && (known.multiple != null || !times.isSteady || !multiples.isSteady))
            {
                return known;
            }
            var entry:Object = addNumber(figure, subject, variant, times.median / NS_PER_MS, "ms", thesis);
            entry.value = times.median / NS_PER_MS;
            delete entry.refused;
            entry.low = times.low / NS_PER_MS;
            entry.high = times.high / NS_PER_MS;
            entry.samples = times.count;
            entry.multiple = multiples.isSteady ? multiples.median : null;
            entry.multipleLow = multiples.low;
            entry.multipleHigh = multiples.high;
            if (!times.isSteady)
            {
                entry.value = entry.multiple = null;
                entry.refused = times.median > 0 ? "±" + Math.round(times.spread * 100) + " %, noisy" : "too short for the clock";
            }
            return entry;
        }

        /**
         * All entries as JSON.
         *
         * @param isComplete whether the run is at its end
         */
        public function toText(isComplete:Boolean = true):String
        {
            return JSON.stringify({player: Host.player, settings: settings, isComplete: isComplete, entries: _entries}, null, 1);
        }

        private static function hasDiffered(entry:Object, index:int, all:Array):Boolean
        {
            return entry.agrees === false;
        }

        private static function nameOf(figure:String, subject:String, variant:String):String
        {
            return [figure, subject, variant].join(" / ");
        }
    }
}
