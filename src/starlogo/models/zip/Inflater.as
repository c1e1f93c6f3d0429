package starlogo.models.zip
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.models.refuseIf;
    import starlogo.steps.Steps;

    /**
     * Unpacks a file of a zip archive (RFC 1951), in steps. The archive gives the file's size. If the content is longer, the file is
     * refused before it takes more memory than that.
     */
    internal final class Inflater implements Steps
    {
        // one byte of packed data makes at most this many bytes
        private static const MAX_RATIO:int = 1032;
        private static const LONGEST_MATCH:int = 258;
        private static const BYTES_PER_STEP:int = 6000;

        // from this many bytes on, the player's own copy is faster than a loop
        private static const WORTH_A_CALL:int = 32;

        private static const SHORT_MASK:int = (1 << HuffmanCode.SHORT_LENGTH) - 1;
        private static const END_OF_BLOCK:int = 256;
        private static const LENGTH_CODES:int = 29;
        private static const DISTANCE_CODES:int = 30;

        // Bits are read two bytes at a time, before it is known that they are needed.
        private static const PADDING:int = 8;

        // the order in which the lengths of the code length codes are stored
        private static const ORDER:Vector.<int> = new <int>[16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];

        private static var sFixedSymbols:HuffmanCode = null;
        private static var sFixedDistances:HuffmanCode = null;

        /** The file, when no step is left. */
        public var content:ByteArray = new ByteArray();

        private var _name:String;
        private var _path:String;
        private var _size:int;
        private var _written:int = 0;

        // the packed data, and the bits of it that are read but not used yet
        private var _packed:ByteArray = new ByteArray();
        private var _bits:int = 0;
        private var _bitCount:int = 0;

        private var _isInBlock:Boolean = false;
        private var _isLastBlock:Boolean = false;
        private var _symbols:HuffmanCode;
        private var _distances:HuffmanCode;

        /**
         * @param name the model's name
         * @param path the file's path, for errors
         * @param packed the file's bytes in the archive; changed
         * @param isDeflated whether they are packed
         * @param size the number of bytes that the unpacked file must have
         * @throws ModelError if the packed bytes cannot make so many
         */
        public function Inflater(name:String, path:String, packed:ByteArray, isDeflated:Boolean, size:uint)
        {
            _name = name;
            _path = path;
            _size = size;
            refuseSize(size > MAX_RATIO * Number(packed.length), "fewer");
            if (isDeflated)
            {
                _packed = packed;
            }
            else
            {
                content = packed;
                _written = packed.length;
                _isLastBlock = true;
            }
            _packed.endian = Endian.LITTLE_ENDIAN;
            _packed.length += PADDING;
            _packed.position = 0;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            try
            {
                if (_isInBlock)
                {
                    unpackSome();
                }
                else if (!_isLastBlock)
                {
                    beginBlock();
                }
                refuse(_packed.position - (_bitCount >> 3) > _packed.length - PADDING, "it is cut off");
            }
            catch (failure:ArgumentError)
            {
                refuseIf(true, _name, ZipArchive.PROBLEM + _path + " can't be unpacked: " + failure.message);
            }
            refuseSize(_written > _size, "more");
            if (_isInBlock || !_isLastBlock)
            {
                return true;
            }
            refuseSize(_written < _size, "fewer");
            content.length = _size;
            content.position = 0;
            return false;
        }

        private function refuseSize(isWrong:Boolean, amount:String):void
        {
            refuseIf(isWrong, _name, ZipArchive.PROBLEM + _path + " should have " + _size + " bytes unpacked, but has " + amount);
        }

        private static function refuse(isWrong:Boolean, problem:String):void
        {
            if (isWrong)
            {
                throw new ArgumentError(problem);
            }
        }

        private function beginBlock():void
        {
            _isLastBlock = readBits(1) == 1;
            var kind:int = readBits(2);
            refuse(kind == 3, "it has a block of an unknown kind");
            if (kind == 0)
            {
                copyStored();
                return;
            }
            _isInBlock = true;
            if (kind == 1)
            {
                useFixedCodes();
            }
            else
            {
                readCodes();
            }
        }

        private function copyStored():void
        {
            _packed.position -= _bitCount >> 3;
            _bits = 0;
            _bitCount = 0;
            var length:int = readBits(16);
            refuse(readBits(16) != (length ^ 0xFFFF), "it has a block whose two lengths differ");
            refuse(length > _packed.bytesAvailable, "it is cut off");
            refuseSize(_written + length > _size, "more");
            content.position = _written;
            if (length > 0)
            {
                content.writeBytes(_packed, _packed.position, length);
            }
            _packed.position += length;
            _written += length;
        }

        private function useFixedCodes():void
        {
            if (sFixedSymbols == null)
            {
                var lengths:Vector.<int> = new Vector.<int>(288);
                var distances:Vector.<int> = new Vector.<int>(32);
                for (var i:int = 0; i < 288; i++)
                {
                    lengths[i] = i < 144 || i > 279 ? 8 : i < 256 ? 9 : 7;
                    distances[i & 31] = 5;
                }
                sFixedSymbols = new HuffmanCode(lengths);
                sFixedDistances = new HuffmanCode(distances);
            }
            _symbols = sFixedSymbols;
            _distances = sFixedDistances;
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
        }

        private function readLengths(code:HuffmanCode, count:int):Vector.<int>
        {
            var lengths:Vector.<int> = new Vector.<int>();
            while (lengths.length < count)
            {
                var symbol:int = readSymbol(code);
                refuse(symbol == 16 && lengths.length == 0, "it repeats a length that is not there");
                var length:int = symbol < 16 ? symbol : (symbol == 16 ? lengths[lengths.length - 1] : 0);
                var times:int = symbol < 16 ? 1 : (symbol == 18 ? 11 + readBits(7) : 3 + readBits(symbol - 14));
                for (var i:int = 0; i < times; i++)
                {
                    lengths.push(length);
                }
            }
            refuse(lengths.length > count, "it has more code lengths than codes");
            return lengths;
        }

        private function readSymbol(code:HuffmanCode):int
        {
            refill();
            var entry:int = code.entries[_bits & SHORT_MASK] || code.longEntry(_bits);
            readBits(entry & 15);
            return entry >> 4;
        }

        private function readBits(count:int):int
        {
            refill();
            var value:int = _bits & (1 << count) - 1;
            _bits >>= count;
            _bitCount -= count;
            return value;
        }

        // Makes sure that at least 16 bits are available. There are never more than 31, so they fit an int.
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
            refuse(_packed.bytesAvailable < 2, "it is cut off");
            return _packed.readUnsignedShort();
        }

        // Contains a copy of readSymbol(), because reading literal bytes takes most of the time.
        private function unpackSome():void
        {
            var out:ByteArray = content;
            var code:HuffmanCode = _symbols;
            var entries:Vector.<int> = code.entries;
            var bits:int = _bits;
            var bitCount:int = _bitCount;
            var written:int = _written;
            var end:int = Math.min(_written + BYTES_PER_STEP, _size + 1);
            if (content.length < end + LONGEST_MATCH)
            {
                content.length = Math.min(2 * end, _size) + LONGEST_MATCH + BYTES_PER_STEP;
            }
            while (written < end)
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
                if (symbol < END_OF_BLOCK)
                {
                    out[written++] = symbol;
                    continue;
                }
                _bits = bits;
                _bitCount = bitCount;
                _isInBlock = symbol != END_OF_BLOCK;
                if (!_isInBlock)
                {
                    break;
                }
                written = repeat(symbol - END_OF_BLOCK - 1, written);
                bits = _bits;
                bitCount = _bitCount;
            }
            _bits = bits;
            _bitCount = bitCount;
            _written = written;
        }

        // Copies bytes from earlier output. Returns the end of the copy.
        private function repeat(code:int, written:int):int
        {
            var out:ByteArray = content;
            refuse(code >= LENGTH_CODES, "it has a length of an unknown kind");
            var end:int = written + (code == LENGTH_CODES - 1 ? LONGEST_MATCH : valueOf(code, 2, 3));
            code = readSymbol(_distances);
            refuse(code >= DISTANCE_CODES, "it has a distance of an unknown kind");
            var from:int = written - valueOf(code, 1, 1);
            refuse(from < 0, "it repeats bytes that are not there");
            while (written < end)
            {
                // each copy doubles the length of the part that can be copied
                var count:int = Math.min(end - written, written - from);
                if (count >= WORTH_A_CALL)
                {
                    out.position = written;
                    out.writeBytes(out, from, count);
                    written += count;
                    continue;
                }
                for (var last:int = from + count; from < last; from++)
                {
                    out[written++] = out[from];
                }
                from -= count;
            }
            return written;
        }

        /**
         * The number that a length code or distance code stands for.
         *
         * @param shift each code has this many digits of the number below its highest bit
         * @param least the number of the first code
         */
        private function valueOf(code:int, shift:int, least:int):int
        {
            var extra:int = (code >> shift) - 1;
            return extra < 1 ? code + least : ((1 << shift | code & (1 << shift) - 1) << extra) + least + readBits(extra);
        }
    }
}
