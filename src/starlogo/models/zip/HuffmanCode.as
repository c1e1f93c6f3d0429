package starlogo.models.zip
{
    /** A canonical Huffman code of a deflated text (RFC 1951, 3.2.2), for decoding. */
    internal final class HuffmanCode
    {
        /** The length of the longest code, in bits. */
        internal static const MAX_LENGTH:int = 15;

        /** How many bits are enough for most codes: <code>entries</code> has as many as these bits have values. */
        internal static const SHORT_LENGTH:int = 10;

        /**
         * What the next bits say, by the lowest SHORT_LENGTH of them: a symbol times 16, plus the length of its code; 0
         * where the code is longer, or none.
         */
        internal var entries:Vector.<int> = new Vector.<int>(1 << SHORT_LENGTH, true);

        // how many codes have a length, and the symbols in the order of their codes
        private var _counts:Vector.<int> = new Vector.<int>(MAX_LENGTH + 1, true);
        private var _symbols:Vector.<int>;

        /**
         * @param lengths the length of each symbol's code, in bits; 0 for symbols that have none
         * @throws ArgumentError if there are more codes than such lengths allow
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
         * What <code>entries</code> would say if it knew long codes.
         *
         * @param bits the next bits, the first one lowest
         * @throws ArgumentError if no code begins like that
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

        /** The bits of a code come highest first, other numbers' lowest first. */
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
