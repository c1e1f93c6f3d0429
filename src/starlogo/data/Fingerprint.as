package starlogo.data
{
    import flash.utils.ByteArray;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * A fingerprint of data: 64 bits that depend on every bit of the data and on their order. It consists of two of Bob Jenkins's
     * one-at-a-time hashes ("Hash functions", Dr. Dobb's Journal, September 1997), which take 32 bits at a time instead of 8. Data that
     * differ in a single word always have different fingerprints. A deliberate search can find different data with the same fingerprint.
     *
     * @private
     */
    public final class Fingerprint
    {
        /** The number of bytes that it takes in a ByteArray. */
        public static const LENGTH:int = 8;

        private static const NUMBERS_PER_STEP:int = 5000;

        private var _low:int = 0x3C6EF372;
        private var _high:int = 0x1B873593;

        /** The fingerprint of a text. */
        public static function of(text:String):Fingerprint
        {
            var fingerprint:Fingerprint = new Fingerprint();
            fingerprint.addText(text);
            return fingerprint;
        }

        /** Adds one word. */
        public function addWord(word:int):void
        {
            addWords(word, word ^ 0x5BD1E995);
        }

        /** Adds letters. */
        public function addText(text:String):void
        {
            for (var i:int = 0; i < text.length; i++)
            {
                addWord(text.charCodeAt(i));
            }
            addWord(text.length);
        }

        /**
         * Adds bytes in groups of eight.
         *
         * @param bytes read from its position on, in its own byte order
         * @param groupCount the number of groups
         */
        public function addGroups(bytes:ByteArray, groupCount:int):void
        {
            for (var i:int = 0; i < groupCount; i++)
            {
                addWords(bytes.readInt(), bytes.readInt());
            }
        }

        /**
         * The steps that add two lists: every bit of every number and index.
         *
         * @param numbers for example the coordinates of a model's vertices
         * @param indices for example those of its triangles; null if there are none
         */
        public function addingLists(numbers:Vector.<Number>, indices:Vector.<uint>):Steps
        {
            addWord(numbers.length);
            return new StepSequence().slices(numbers.length, NUMBERS_PER_STEP, function(first:int, end:int):void
                {
                    var bytes:ByteArray = new ByteArray();
                    for (var i:int = first; i < end; i++)
                    {
                        bytes.writeDouble(numbers[i]);
                    }
                    bytes.position = 0;
                    addGroups(bytes, end - first);
                }).slices(indices == null ? 0 : indices.length, NUMBERS_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        addWord(indices[i]);
                    }
                });
        }

        // Adds a word to each of the two hashes. The second one also takes the first, because the second word of numbers with few digits is 0.
        private function addWords(low:int, high:int):void
        {
            _low ^= low;
            _low += _low << 10;
            _low ^= _low >>> 6;
            _high ^= high ^ _low;
            _high += _high << 10;
            _high ^= _high >>> 6;
        }

        /** Writes the fingerprint. */
        public function writeTo(bytes:ByteArray):void
        {
            bytes.writeInt(_low);
            bytes.writeInt(_high);
        }

        /** Reads the next bytes. Returns whether they are this fingerprint. */
        public function readAndCompare(bytes:ByteArray):Boolean
        {
            var low:int = bytes.readInt();
            var high:int = bytes.readInt();
            return low == _low && high == _high;
        }

        /** The fingerprint as sixteen hexadecimal digits. */
        public function toString():String
        {
            return hexadecimal(_high) + hexadecimal(_low);
        }

        private static function hexadecimal(word:int):String
        {
            var digits:uint = word;
            return ("0000000" + digits.toString(16)).slice(-8);
        }
    }
}
