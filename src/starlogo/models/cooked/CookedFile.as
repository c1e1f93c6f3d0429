package starlogo.models.cooked
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.geometry.Fingerprint;
    import starlogo.models.ModelLimits;
    import starlogo.steps.StepSequence;

    /**
     * What was computed once and written down (docs/cooked.md): sections, each of which is for some settings, deflated and sealed with a
     * fingerprint. It is read in steps. Bytes that are no such file, that are cut off or have changed have no sections; what a section says
     * is checked where it is used.
     *
     * <pre>
     * at 0   "COOK"
     *    4   the version of the form
     *    8   the length of the whole in bytes, a multiple of 8
     *   12   the length of all sections, unpacked
     *   16   for each of four sections the fingerprint of what it is for, its length, 0
     *   80   the sections in pieces of at most 16,384 bytes: the length of the deflated piece, the piece
     *        zeros up to a multiple of 8
     *   end  the fingerprint of all before
     * </pre>
     *
     * @private
     */
    public final class CookedFile extends StepSequence
    {
        /** The section with the model itself: for the arguments that it is loaded with; in a FitStore an empty one, for the geometry. */
        public static const MODEL:int = 0;

        /** Its structures, for the fitters. */
        public static const STRUCTURES:int = 1;

        /** Its hierarchy, for the settings of that. */
        public static const HIERARCHY:int = 2;

        /** Its surface, for the same. */
        public static const SURFACE:int = 3;

        /** How many sections there are. */
        public static const SECTIONS:int = 4;

        private static const MAGIC:int = 0x4B4F4F43;
        private static const VERSION:int = 1;
        private static const TABLE:int = 16;
        private static const ENTRY_LENGTH:int = 16;
        private static const HEAD_LENGTH:int = TABLE + SECTIONS * ENTRY_LENGTH;
        private static const PIECE_LENGTH:int = 16384;

        // Deflating makes a piece longer by less than this; a piece that was forged unpacks to 1032 times its length at most.
        private static const PIECE_EXCESS:int = 256;

        private static const WORDS_PER_STEP:int = 4000;

        private var _bytes:ByteArray;
        private var _whole:Fingerprint = new Fingerprint();
        private var _unpackedLength:int = 0;
        private var _unpacked:ByteArray = newBytes();
        private var _isWhole:Boolean = false;

        /**
         * @param bytes what may be such a file; changed in nothing but position and byte order; null for none
         */
        public function CookedFile(bytes:ByteArray)
        {
            _bytes = bytes;
            if (bytes != null && isCooked(bytes) && hasHead())
            {
                bytes.position = 0;
                slices(bytes.length / Fingerprint.LENGTH - 1, WORDS_PER_STEP, addWords).call(open);
            }
        }

        /** Whether bytes start as a cooked file does. */
        public static function isCooked(bytes:ByteArray):Boolean
        {
            bytes.endian = Endian.LITTLE_ENDIAN;
            bytes.position = 0;
            return bytes.length >= HEAD_LENGTH + Fingerprint.LENGTH && bytes.readInt() == MAGIC;
        }

        /**
         * The bytes of a file.
         *
         * @param settings what each section is for; null for an empty one that is for nothing
         * @param sections their bytes
         */
        public static function write(settings:Vector.<Fingerprint>, sections:Vector.<ByteArray>):ByteArray
        {
            var all:ByteArray = newBytes();
            var out:ByteArray = newBytes();
            out.length = out.position = TABLE;
            for (var i:int = 0; i < SECTIONS; i++)
            {
                var wanted:Fingerprint = settings[i] || new Fingerprint();
                wanted.writeTo(out);
                out.writeInt(sections[i].length);
                out.writeInt(0);
                all.writeBytes(sections[i]);
            }
            for (var at:int = 0; at < all.length; at += PIECE_LENGTH)
            {
                var piece:ByteArray = new ByteArray();
                piece.writeBytes(all, at, Math.min(PIECE_LENGTH, all.length - at));
                piece.deflate();
                out.writeInt(piece.length);
                out.writeBytes(piece);
            }
            out.length = out.position = out.length + 7 & ~7;
            out.position = 0;
            out.writeInt(MAGIC);
            out.writeInt(VERSION);
            out.writeInt(out.length + Fingerprint.LENGTH);
            out.writeInt(all.length);
            seal(out);
            return out;
        }

        /** Writes the fingerprint of bytes, a multiple of 8, behind them; the position is their first then. */
        public static function seal(bytes:ByteArray):void
        {
            var whole:Fingerprint = new Fingerprint();
            bytes.position = 0;
            whole.addBytes(bytes, bytes.length / Fingerprint.LENGTH);
            whole.writeTo(bytes);
            bytes.position = 0;
        }

        /** No bytes, in the byte order that these files have. */
        public static function newBytes():ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            return bytes;
        }

        /** Whether the bytes were a file that is as it was written, when no step is left. */
        public function get isWhole():Boolean
        {
            return _isWhole;
        }

        /** Whether the model is for some arguments, of a file that is whole. */
        public function isFor(settings:Fingerprint):Boolean
        {
            if (_isWhole)
            {
                _bytes.position = TABLE;
            }
            return _isWhole && settings.isNextOf(_bytes);
        }

        /**
         * The bytes of a section, at the first of them.
         *
         * @param index its number
         * @param wanted what it has to be for; null for whatever it is for
         * @return null if there is none, or it is for something else
         */
        public function section(index:int, wanted:Fingerprint):ByteArray
        {
            if (!_isWhole)
            {
                return null;
            }
            var start:int = 0;
            for (var i:int = 0; i < index; i++)
            {
                start += lengthOf(i);
            }
            var length:int = lengthOf(index);
            _bytes.position = TABLE + ENTRY_LENGTH * index;
            if (length == 0 || wanted != null && !wanted.isNextOf(_bytes))
            {
                return null;
            }
            var bytes:ByteArray = newBytes();
            bytes.writeBytes(_unpacked, start, length);
            bytes.position = 0;
            return bytes;
        }

        private function lengthOf(index:int):int
        {
            _bytes.position = TABLE + ENTRY_LENGTH * index + Fingerprint.LENGTH;
            return _bytes.readInt();
        }

        private function hasHead():Boolean
        {
            var length:int = _bytes.length;
            return length % Fingerprint.LENGTH == 0 && length <= ModelLimits.BYTES && _bytes.readInt() == VERSION && _bytes.readInt() == length;
        }

        private function addWords(first:int, end:int):void
        {
            _whole.addBytes(_bytes, end - first);
        }

        private function open():void
        {
            if (!_whole.isNextOf(_bytes))
            {
                return;
            }
            _bytes.position = TABLE - 4;
            _unpackedLength = _bytes.readInt();
            var rest:Number = _unpackedLength;
            for (var i:int = 0; i < SECTIONS; i++)
            {
                var length:int = lengthOf(i);
                rest = length < 0 ? NaN : rest - length;
            }
            if (rest == 0)
            {
                _bytes.position = HEAD_LENGTH;
                repeat(unpackPiece);
            }
        }

        private function unpackPiece():Boolean
        {
            var expected:int = Math.min(PIECE_LENGTH, _unpackedLength - _unpacked.length);
            if (expected > 0)
            {
                var length:int = _bytes.bytesAvailable < 4 ? 0 : _bytes.readInt();
                if (length <= 0 || length > PIECE_LENGTH + PIECE_EXCESS || length > _bytes.bytesAvailable - Fingerprint.LENGTH)
                {
                    return false;
                }
                var piece:ByteArray = new ByteArray();
                piece.writeBytes(_bytes, _bytes.position, length);
                _bytes.position += length;
                if (!isInflated(piece) || piece.length != expected)
                {
                    return false;
                }
                _unpacked.writeBytes(piece);
            }
            _isWhole = _unpacked.length == _unpackedLength;
            return !_isWhole;
        }

        private static function isInflated(piece:ByteArray):Boolean
        {
            try
            {
                piece.inflate();
            }
            catch (error:Error)
            {
                return false;
            }
            return true;
        }
    }
}
