package evaluation.pairs
{
    /**
     * Random numbers that are the same on every run: xorshift32 (Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8(14), 2003).
     * Each Number takes two draws.
     */
    public final class SeededRandom
    {
        private var _state:uint;

        /**
         * @param seed any number but 0
         */
        public function SeededRandom(seed:uint)
        {
            if (seed == 0)
            {
                throw new ArgumentError("the seed must not be 0");
            }
            _state = seed;
            for (var i:int = 0; i < 8; i++)
            {
                nextUint();
            }
        }

        /** The next 32 bits. */
        public function nextUint():uint
        {
            _state ^= _state << 13;
            _state ^= _state >>> 17;
            _state ^= _state << 5;
            return _state;
        }

        /** Uniform in [0, 1), with 53 bits. */
        public function next():Number
        {
            return ((nextUint() >>> 5) * 67108864 + (nextUint() >>> 6)) / 9007199254740992;
        }

        /** Uniform in [low, high). */
        public function between(low:Number, high:Number):Number
        {
            return low + (high - low) * next();
        }

        /** Uniform among low, low + 1, ... high. */
        public function integer(low:int, high:int):int
        {
            return low + int(next() * (high - low + 1));
        }

        /** Uniform in the exponent: numbers between 0.1 and 1 are as frequent as between 1 and 10. */
        public function logBetween(low:Number, high:Number):Number
        {
            return Math.exp(between(Math.log(low), Math.log(high)));
        }

        /** True with the given probability. */
        public function chance(probability:Number = 0.5):Boolean
        {
            return next() < probability;
        }

        /** Normally distributed with mean 0 and deviation 1 (Box and Muller). */
        public function normal():Number
        {
            return Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next());
        }

        /** A random element of an array. */
        public function pick(from:Array):*
        {
            return from[integer(0, from.length - 1)];
        }
    }
}
