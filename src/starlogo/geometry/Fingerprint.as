package starlogo.geometry
{
    import flash.utils.ByteArray;

    /**
     * Tells data apart: 64 bits that depend on every bit of the data and on their order. Made of two of Bob Jenkins's one-at-a-time
     * hashes ("Hash functions", Dr. Dobb's Journal, September 1997) that take 32 bits at a time in place of 8: of two that
     * differ in a single word the fingerprints always differ. Not proof against a search for two that are alike.
     *
     * @private
     */
    public final class Fingerprint
    {
        /** How many bytes it has in a ByteArray. */
        public static const LENGTH:int = 8;

        private var _low:int = 0x3C6EF372;
        private var _high:int = 0x1B873593;

        /** The fingerprint of nothing. */
        public function Fingerprint()
        {
        }

        /** Adds one word. */
        public function addWord(word:int):void
        {
            _low ^= word;
            _low += _low << 10;
            _low ^= _low >>> 6;
            _high ^= word ^ 0x5BD1E995;
            _high += _high << 10;
            _high ^= _high >>> 6;
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
         * Adds bytes, eight at a time.
         *
         * @param bytes read from its position on, in the byte order that it has
         * @param count how many times eight
         */
        public function addBytes(bytes:ByteArray, count:int):void
        {
            var low:int = _low;
            var high:int = _high;
            for (var i:int = 0; i < count; i++)
            {
                low ^= bytes.readInt();
                low += low << 10;
                low ^= low >>> 6;
                high ^= bytes.readInt();
                high += high << 10;
                high ^= high >>> 6;
            }
            _low = low;
            _high = high;
        }

        /** Writes it. */
        public function writeTo(bytes:ByteArray):void
        {
            bytes.writeInt(_low);
            bytes.writeInt(_high);
        }

        /** Whether the next bytes are this fingerprint. */
        public function isNextOf(bytes:ByteArray):Boolean
        {
            var low:int = bytes.readInt();
            var high:int = bytes.readInt();
            return low == _low && high == _high;
        }

        /** Sixteen hexadecimal digits. */
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
