package standin
{
    /** Rounds numbers to single precision, as in a float of 32 bits. It uses only arithmetic, so it works on every machine. */
    public final class SinglePrecision
    {
        private static const FROM_INFINITE:Number = Math.pow(2, 128) - Math.pow(2, 103);
        private static const FROM_NORMAL:Number = Math.pow(2, -126);

        // Sums with this number are rounded to multiples of the smallest float.
        private static const SUBNORMAL_STEP:Number = 1.5 * Math.pow(2, -97);

        // a split by 2^n + 1 leaves 53 - n bits
        private static const SINGLE_SPLIT:Number = Math.pow(2, 29) + 1;
        private static const EVEN_SPLIT:Number = Math.pow(2, 30) + 1;

        /** The nearest number of single precision. Of two equally near numbers, the even one. */
        public static function round(x:Number):Number
        {
            var size:Number = x < 0 ? -x : x;
            if (!(size < FROM_INFINITE))
            {
                return x * Infinity; // NaN stays NaN
            }
            if (size < FROM_NORMAL)
            {
                size = size + SUBNORMAL_STEP - SUBNORMAL_STEP;
                return size == 0 ? x * 0 : (x < 0 ? -size : size);
            }
            var near:Number = leading(x, SINGLE_SPLIT);
            var other:Number = x + (x - near);
            var isTie:Boolean = other != x && leading(other, SINGLE_SPLIT) == other;
            return isTie && leading(near, EVEN_SPLIT) != near ? other : near;
        }

        /** The leading bits of a number, rounded, by Veltkamp's split. */
        private static function leading(x:Number, split:Number):Number
        {
            var product:Number = x * split;
            return product - (product - x);
        }
    }
}
