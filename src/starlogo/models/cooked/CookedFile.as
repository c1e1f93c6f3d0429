package starlogo.models.cooked
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.geometry.Fingerprint;
    import starlogo.models.ModelLimits;
    import starlogo.steps.StepSequence;

    /**
     * What was computed once and written down (docs/cooked.md): sections, each of which is for some settings, sealed with a fingerprint.
     * It is read in steps. Bytes that are no such file, that are cut off or have changed have no sections; what a section says is
     * checked where it is used.
     *
     * <pre>
     * at 0   "COOK"
     *    4   the version of the form
     *    8   the length of the whole in bytes, a multiple of 8
     *   12   0
     *   16   for each of four sections the fingerprint of what it is for, its length, 0
     *   80   the sections, one after the other; zeros up to a multiple of 8
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
        private static const LENGTH_AT:int = 8;
        private static const TABLE:int = 16;
        private static const ENTRY_LENGTH:int = 16;
        private static const HEAD_LENGTH:int = TABLE + SECTIONS * ENTRY_LENGTH;
        private static const WORDS_PER_STEP:int = 4000;

        private var _bytes:ByteArray = newBytes();
        private var _whole:Fingerprint = new Fingerprint();
        private var _isWhole:Boolean = false;

        /**
         * @param bytes what may be such a file, which is copied; changed in nothing but position and byte order; null for none
         */
        public function CookedFile(bytes:ByteArray)
        {
            if (bytes != null && isCooked(bytes) && hasHead(bytes))
            {
                _bytes.writeBytes(bytes);
                _bytes.position = 0;
                slices(bytes.length / Fingerprint.LENGTH - 1, WORDS_PER_STEP, addWords).call(check);
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
            var out:ByteArray = newBytes();
            out.writeInt(MAGIC);
            out.writeInt(VERSION);
            out.length = out.position = TABLE;
            for (var i:int = 0; i < SECTIONS; i++)
            {
                var wanted:Fingerprint = settings[i] || new Fingerprint();
                wanted.writeTo(out);
                out.writeInt(sections[i].length);
                out.writeInt(0);
            }
            for each (var section:ByteArray in sections)
            {
                out.writeBytes(section);
            }
            out.length = out.length + 7 & ~7;
            out.position = LENGTH_AT;
            out.writeInt(out.length + Fingerprint.LENGTH);
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
            var start:int = HEAD_LENGTH;
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
            bytes.writeBytes(_bytes, start, length);
            bytes.position = 0;
            return bytes;
        }

        private function lengthOf(index:int):int
        {
            _bytes.position = TABLE + ENTRY_LENGTH * index + Fingerprint.LENGTH;
            return _bytes.readInt();
        }

        private function addWords(first:int, end:int):void
        {
            _whole.addBytes(_bytes, end - first);
        }

        private function check():void
        {
            var rest:Number = _bytes.length - HEAD_LENGTH - Fingerprint.LENGTH;
            var isSealed:Boolean = _whole.isNextOf(_bytes);
            for (var i:int = 0; i < SECTIONS; i++)
            {
                var length:int = lengthOf(i);
                rest = length < 0 ? NaN : rest - length;
            }
            _isWhole = isSealed && rest >= 0 && rest < Fingerprint.LENGTH;
        }

        private static function hasHead(bytes:ByteArray):Boolean
        {
            var length:int = bytes.length;
            return length % Fingerprint.LENGTH == 0 && length <= ModelLimits.BYTES && bytes.readInt() == VERSION && bytes.readInt() == length;
        }
    }
}
