package evaluation
{
    /** Repeated measurements of one thing. */
    public final class Samples
    {
        /** If half the range of the samples is more than this part of their median, they say nothing. */
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

        /** The number of samples. */
        public function get count():int
        {
            return _sorted.length;
        }

        /** The median. For an even number it is the mean of the middle two. */
        public function get median():Number
        {
            var middle:int = count / 2;
            return count % 2 == 1 ? _sorted[middle] : (_sorted[middle - 1] + _sorted[middle]) / 2;
        }

        /** The lowest sample, without the lowest fifth, which may be accidents: one of five samples, two of ten. */
        public function get low():Number
        {
            return _sorted[int(count / 5)];
        }

        /** The highest sample, without the highest fifth, which may be accidents. */
        public function get high():Number
        {
            return _sorted[count - 1 - int(count / 5)];
        }

        /** Half the distance between <code>low</code> and <code>high</code>, as a part of the median. */
        public function get spread():Number
        {
            return (high - low) / 2 / median;
        }

        /** Whether the samples are reliable: close enough together, and long enough for the clock. */
        public function get isSteady():Boolean
        {
            return median > 0 && spread <= WIDEST_SPREAD;
        }
    }
}
