package starlogo.models.zip
{
    /** Decodes a canonical Huffman code of deflated data (RFC 1951, section 3.2.2). */
    internal final class HuffmanCode
    {
        /** The length of the longest code, in bits. */
        internal static const MAX_LENGTH:int = 15;

        /** Most codes are at most this long, in bits. <code>entries</code> has an entry for each value of this many bits. */
        internal static const SHORT_LENGTH:int = 10;

        /**
         * The meaning of the next bits. The index is the lowest SHORT_LENGTH bits. An entry is the symbol times 16, plus the length of its
         * code; 0 if the code is longer or unknown.
         */
        internal var entries:Vector.<int> = new Vector.<int>(1 << SHORT_LENGTH, true);

        // the number of codes of each length, and the symbols in the order of their codes
        private var _counts:Vector.<int> = new Vector.<int>(MAX_LENGTH + 1, true);
        private var _symbols:Vector.<int>;

        /**
         * @param lengths the length of each symbol's code, in bits; 0 for symbols without a code
         * @throws ArgumentError if there are too many codes for these lengths
         */
        public function HuffmanCode(lengths:Vector.<int>)
        {
            _symbols = new Vector.<int>(lengths.length, true);
            for each (var length:int in lengths)
            {
                _counts[length]++;
            }
            _counts[0] = 0;
            var firstCodes:Vector.<int> = new Vector.<int>(MAX_LENGTH + 1, true);
            var firstPlaces:Vector.<int> = new Vector.<int>(MAX_LENGTH + 1, true);
            for (length = 1; length <= MAX_LENGTH; length++)
            {
                firstCodes[length] = firstCodes[length - 1] + _counts[length - 1] << 1;
                firstPlaces[length] = firstPlaces[length - 1] + _counts[length - 1];
                if (firstCodes[length] + _counts[length] > 1 << length)
                {
                    throw new ArgumentError("it has too many codes of " + length + " bits: " + _counts[length]);
                }
            }
            for (var symbol:int = 0; symbol < lengths.length; symbol++)
            {
                length = lengths[symbol];
                if (length > 0)
                {
                    _symbols[firstPlaces[length]++] = symbol;
                    enter(symbol, firstCodes[length]++, length);
                }
            }
        }

        /**
         * The entry of a code that is longer than SHORT_LENGTH.
         *
         * @param bits the next bits, the first one lowest
         * @throws ArgumentError if no code begins with these bits
         */
        internal function longEntry(bits:int):int
        {
            var code:int = 0;
            var first:int = 0;
            var place:int = 0;
            for (var length:int = 1; length <= MAX_LENGTH; length++)
            {
                code |= bits & 1;
                bits >>= 1;
                var count:int = _counts[length];
                if (code - first < count)
                {
                    return _symbols[place + code - first] << 4 | length;
                }
                place += count;
                first = first + count << 1;
                code <<= 1;
            }
            throw new ArgumentError("it has bits that are no code");
        }

        /** A code is stored with its highest bit first, but other numbers with their lowest bit first. So the code's bits are reversed. */
        private function enter(symbol:int, code:int, length:int):void
        {
            if (length > SHORT_LENGTH)
            {
                return;
            }
            var reversed:int = 0;
            for (var i:int = 0; i < length; i++)
            {
                reversed = reversed << 1 | code >> i & 1;
            }
            for (i = reversed; i < 1 << SHORT_LENGTH; i += 1 << length)
            {
                entries[i] = symbol << 4 | length;
            }
        }
    }
}
