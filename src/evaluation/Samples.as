package evaluation
{
    /** Repeated measurements of one thing. */
    public final class Samples
    {
        /** Half the range of the samples in parts of their median, above which they say nothing. */
        public static const WIDEST_SPREAD:Number = 0.3;

        private var _sorted:Array;

        /**
         * @param values the measurements, in any order; at least one
         */
        public function Samples(values:Array)
        {
            _sorted = values.concat();
            _sorted.sort(Array.NUMERIC);
        }

        /** How many there are. */
        public function get count():int
        {
            return _sorted.length;
        }

        /** The one in the middle; the mean of two where the number is even. */
        public function get median():Number
        {
            var middle:int = count / 2;
            return count % 2 == 1 ? _sorted[middle] : (_sorted[middle - 1] + _sorted[middle]) / 2;
        }

        /** The least, without a fifth that may be accidents: one of five samples, two of ten. */
        public function get low():Number
        {
            return _sorted[int(count / 5)];
        }

        /** The greatest, without a fifth that may be accidents. */
        public function get high():Number
        {
            return _sorted[count - 1 - int(count / 5)];
        }

        /** Half the distance between the least and the greatest, in parts of the median. */
        public function get spread():Number
        {
            return (high - low) / 2 / median;
        }

        /** Whether they are close enough together, and resolved by the clock, to mean something. */
        public function get isSteady():Boolean
        {
            return median > 0 && spread <= WIDEST_SPREAD;
        }
    }
}
