package soak
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import support.MemoryStorage;
    import support.Mutations;

    /** Keeps the fits of a soak's models, and gives some back damaged. */
    internal final class SoakStorage extends MemoryStorage
    {
        private static const DAMAGED:Number = 0.3;

        private var _random:SeededRandom;
        private var _counts:SoakCounts;

        /**
         * @param random decides
         * @param counts is told
         */
        public function SoakStorage(random:SeededRandom, counts:SoakCounts)
        {
            _random = random;
            _counts = counts;
        }

        /** @inheritDoc */
        override public function read(name:String):ByteArray
        {
            var bytes:ByteArray = super.read(name);
            if (bytes == null || name == "index")
            {
                return bytes;
            }
            if (_random.chance(DAMAGED))
            {
                _counts.add("fits read damaged");
                return Mutations.ofBytes(bytes, _random);
            }
            _counts.add("fits read");
            return bytes;
        }
    }
}
