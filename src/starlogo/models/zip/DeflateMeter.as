package starlogo.models.zip
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.steps.Steps;

    /**
     * Counts the bytes that deflated data (RFC 1951) would unpack to, without unpacking them: a few bytes may unpack to hundreds of megabytes. It
     * stops at a limit.
     */
    internal final class DeflateMeter implements Steps
    {
        /** How many times its packed size a file can have at most: 258 bytes of two bits. */
        public static const MAX_RATIO:int = 1032;

        private static const SYMBOLS_PER_STEP:int = 4000;
        private static const SHORT_MASK:int = (1 << HuffmanCode.SHORT_LENGTH) - 1;
        private static const END_OF_BLOCK:int = 256;

        // zeros after the end, for the bits that are read ahead
        private static const PADDING:int = 8;

        // for the symbols from 257: the lengths that they code, and the numbers of bits that follow them and add to it
        private static const LENGTHS:Vector.<int> = new <int>[3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35,
                43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258];
        private static const LENGTH_BITS:Vector.<int> = new <int>[0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3,
                3, 4, 4, 4, 4, 5, 5, 5, 5, 0];

        // in which order the lengths of the codes for lengths come
        private static const ORDER:Vector.<int> = new <int>[16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];

        private static var sFixedSymbols:HuffmanCode = null;
        private static var sFixedDistances:HuffmanCode = null;

        /** How many bytes there are so far: all when no step is left, or some number beyond the limit. */
        public var size:Number = 0;

        private var _bytes:ByteArray = new ByteArray();
        private var _limit:Number;

        // the bits that are read from the bytes but not used, the next one lowest, and how many
        private var _bits:int = 0;
        private var _bitCount:int = 0;

        private var _isInBlock:Boolean = false;
        private var _isLastBlock:Boolean = false;
        private var _symbols:HuffmanCode;
        private var _distances:HuffmanCode;

        /**
         * @param packed the deflated bytes; copied
         * @param limit counting ends beyond it
         */
        public function DeflateMeter(packed:ByteArray, limit:Number)
        {
            _bytes.endian = Endian.LITTLE_ENDIAN;
            _bytes.writeBytes(packed);
            _bytes.length += PADDING;
            _bytes.position = 0;
            _limit = limit;
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if the bytes are cut off or damaged, as far as that can be seen
         */
        public function step():Boolean
        {
            if (_isInBlock)
            {
                countSymbols();
            }
            else
            {
                beginBlock();
            }
            if (_bytes.position - (_bitCount >> 3) > _bytes.length - PADDING)
            {
                throw new ArgumentError("it is cut off");
            }
            return size <= _limit && (_isInBlock || !_isLastBlock);
        }

        private function beginBlock():void
        {
            _isLastBlock = readBits(1) == 1;
            switch (readBits(2))
            {
                case 0:
                    skipStored();
                    break;
                case 1:
                    useFixedCodes();
                    break;
                case 2:
                    readCodes();
                    break;
                default:
                    throw new ArgumentError("it has a block of an unknown kind");
            }
        }

        private function skipStored():void
        {
            // whole bytes that were read ahead go back
            _bytes.position -= _bitCount >> 3;
            _bits = 0;
            _bitCount = 0;
            var length:int = readBits(16);
            if (readBits(16) != (length ^ 0xFFFF))
            {
                throw new ArgumentError("it has a block of an uncertain length");
            }
            _bytes.position += length;
            size += length;
        }

        private function useFixedCodes():void
        {
            if (sFixedSymbols == null)
            {
                var lengths:Vector.<int> = new Vector.<int>(288);
                for (var i:int = 0; i < 288; i++)
                {
                    lengths[i] = i < 144 || i > 279 ? 8 : i < 256 ? 9 : 7;
                }
                sFixedSymbols = new HuffmanCode(lengths);
                sFixedDistances = new HuffmanCode(new <int>[5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5,
                            5, 5, 5, 5, 5, 5, 5, 5, 5]);
            }
            _symbols = sFixedSymbols;
            _distances = sFixedDistances;
            _isInBlock = true;
        }

        private function readCodes():void
        {
            var symbolCount:int = readBits(5) + 257;
            var distanceCount:int = readBits(5) + 1;
            var count:int = readBits(4) + 4;
            var lengths:Vector.<int> = new Vector.<int>(ORDER.length);
            for (var i:int = 0; i < count; i++)
            {
                lengths[ORDER[i]] = readBits(3);
            }
            lengths = readLengths(new HuffmanCode(lengths), symbolCount + distanceCount);
            _symbols = new HuffmanCode(lengths.slice(0, symbolCount));
            _distances = new HuffmanCode(lengths.slice(symbolCount));
            _isInBlock = true;
        }

        private function readLengths(code:HuffmanCode, count:int):Vector.<int>
        {
            var lengths:Vector.<int> = new Vector.<int>();
            while (lengths.length < count)
            {
                var symbol:int = readSymbol(code);
                var length:int = symbol < 16 ? symbol : 0;
                var times:int = 1;
                if (symbol == 16)
                {
                    if (lengths.length == 0)
                    {
                        throw new ArgumentError("it repeats a length that is not there");
                    }
                    length = lengths[lengths.length - 1];
                    times = 3 + readBits(2);
                }
                else if (symbol > 16)
                {
                    times = symbol == 17 ? 3 + readBits(3) : 11 + readBits(7);
                }
                for (var i:int = 0; i < times; i++)
                {
                    lengths.push(length);
                }
            }
            if (lengths.length > count)
            {
                throw new ArgumentError("it has more lengths of codes than codes");
            }
            return lengths;
        }

        private function readSymbol(code:HuffmanCode):int
        {
            refill();
            var entry:int = code.entries[_bits & SHORT_MASK];
            if (entry == 0)
            {
                entry = code.longEntry(_bits);
            }
            readBits(entry & 15);
            return entry >> 4;
        }

        /** The next bits, 16 at most. */
        private function readBits(count:int):int
        {
            refill();
            var value:int = _bits & (1 << count) - 1;
            _bits >>= count;
            _bitCount -= count;
            return value;
        }

        /** Reads ahead, so that there are at least 16 bits, and at most 31. */
        private function refill():void
        {
            if (_bitCount < 16)
            {
                _bits |= nextShort() << _bitCount;
                _bitCount += 16;
            }
        }

        private function nextShort():int
        {
            if (_bytes.bytesAvailable < 2)
            {
                throw new ArgumentError("it is cut off");
            }
            return _bytes.readUnsignedShort();
        }

        // The inner loop: everything in locals. A length and the distance that follows it are alike: a symbol, and more bits.
        private function countSymbols():void
        {
            var code:HuffmanCode = _symbols;
            var entries:Vector.<int> = code.entries;
            var bits:int = _bits;
            var bitCount:int = _bitCount;
            var counted:Number = size;
            var limit:Number = _limit;
            var isDistance:Boolean = false;
            var i:int = 0;
            while (isDistance || i < SYMBOLS_PER_STEP && counted <= limit)
            {
                if (bitCount < 16)
                {
                    bits |= nextShort() << bitCount;
                    bitCount += 16;
                }
                var entry:int = entries[bits & SHORT_MASK];
                if (entry == 0)
                {
                    entry = code.longEntry(bits);
                }
                bits >>= entry & 15;
                bitCount -= entry & 15;
                var symbol:int = entry >> 4;
                if (symbol < END_OF_BLOCK && !isDistance)
                {
                    counted++;
                    i++;
                    continue;
                }
                if (symbol == END_OF_BLOCK)
                {
                    _isInBlock = false;
                    break;
                }
                var extra:int;
                if (isDistance)
                {
                    // the distance itself does not matter
                    extra = symbol < 4 ? 0 : (symbol >> 1) - 1;
                    i++;
                }
                else
                {
                    symbol -= END_OF_BLOCK + 1;
                    if (symbol >= LENGTHS.length)
                    {
                        throw new ArgumentError("it has a length of an unknown kind");
                    }
                    extra = LENGTH_BITS[symbol];
                }
                if (bitCount < extra)
                {
                    bits |= nextShort() << bitCount;
                    bitCount += 16;
                }
                if (!isDistance)
                {
                    counted += LENGTHS[symbol] + (bits & (1 << extra) - 1);
                }
                bits >>= extra;
                bitCount -= extra;
                isDistance = !isDistance;
                code = isDistance ? _distances : _symbols;
                entries = code.entries;
            }
            _bits = bits;
            _bitCount = bitCount;
            size = counted;
        }
    }
}
