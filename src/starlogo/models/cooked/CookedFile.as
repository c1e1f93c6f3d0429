package starlogo.models.cooked
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.data.Fingerprint;
    import starlogo.models.files.FileBudget;
    import starlogo.steps.StepSequence;

    /**
     * A file with results that were computed earlier: when a game was built (docs/cooked.md), or by a FitStore. It has five sections. A section's
     * key is the fingerprint of what the section depends on. A fingerprint at the end seals the file. It is read in steps. A file has no sections
     * if it is no cooked file, is cut off or has changed. The code that uses a section checks its content.
     *
     * <pre>
     * at 0   "COOK"
     *    4   the version of the layout
     *    8   the length of the whole in bytes, a multiple of 8
     *   12   0
     *   16   for each of the five sections: its key, its length, 0
     *   96   the sections, one after the other; zeros up to a multiple of 8
     *   end  the fingerprint of all bytes before it
     * </pre>
     *
     * @private
     */
    public final class CookedFile extends StepSequence
    {
        /**
         * The section with the model. It depends on the arguments of its load: see <code>keyOfLoad()</code>. A FitStore leaves it empty, and its key is
         * the fingerprint of the model's geometry, on which all other sections depend.
         */
        public static const MODEL:int = 0;

        /** The section with the bounding structures. It depends on the fitters. */
        public static const STRUCTURES:int = 1;

        /** The section with the hierarchy. It depends on the hierarchy's settings. */
        public static const HIERARCHY:int = 2;

        /** The section with the surface. It depends on the hierarchy's settings. */
        public static const SURFACE:int = 3;

        /** The section with the hull. It depends on the fitters, and on the hull's fitter. */
        public static const HULL:int = 4;

        /** The number of sections. */
        public static const SECTION_COUNT:int = 5;

        private static const MAGIC:int = 0x4B4F4F43;
        private static const VERSION:int = 4;

        private static const VERSION_AT:int = 4;
        private static const LENGTH_AT:int = 8;
        private static const TABLE_AT:int = 16;
        private static const ENTRY_LENGTH:int = 16;
        private static const HEAD_LENGTH:int = TABLE_AT + SECTION_COUNT * ENTRY_LENGTH;
        private static const GROUPS_PER_STEP:int = 4000;

        /** Whether the file has another layout, because another version of the engine has made it. */
        public var isOfOtherVersion:Boolean = false;

        private var _bytes:ByteArray = newBytes();

        // whether the file is complete and unchanged; false until all steps are done
        private var _isComplete:Boolean = false;

        /** @param bytes a possible cooked file; it is copied; null for no file */
        public function CookedFile(bytes:ByteArray)
        {
            if (bytes == null || !isCookedFile(bytes))
            {
                return;
            }
            _bytes.writeBytes(bytes);
            _bytes.position = VERSION_AT;
            isOfOtherVersion = _bytes.readInt() != VERSION;
            var length:int = _bytes.readInt(); // at LENGTH_AT
            var isRightLength:Boolean = length == _bytes.length && length % Fingerprint.LENGTH == 0 && length <= FileBudget.MAX_BYTES;
            if (!isOfOtherVersion && isRightLength && length >= HEAD_LENGTH + Fingerprint.LENGTH)
            {
                _bytes.position = 0;
                var whole:Fingerprint = new Fingerprint();
                slices(length / Fingerprint.LENGTH - 1, GROUPS_PER_STEP, function(first:int, end:int):void
                    {
                        whole.addGroups(_bytes, end - first);
                    }).call(function():void
                    {
                        check(whole.readAndCompare(_bytes));
                    });
            }
        }

        /** Whether the bytes begin like a cooked file. */
        public static function isCookedFile(bytes:ByteArray):Boolean
        {
            return bytes.length >= TABLE_AT + Fingerprint.LENGTH && bytes[0] == 0x43 && bytes[1] == 0x4F && bytes[2] == 0x4F && bytes[3] == 0x4B;
        }

        /**
         * Makes the bytes of a file.
         *
         * @param keys the key of each section; null leaves the section empty
         * @param sections the bytes of each section; null for an empty one
         */
        public static function write(keys:Vector.<Fingerprint>, sections:Vector.<ByteArray>):ByteArray
        {
            var out:ByteArray = newBytes();
            out.writeInt(MAGIC);
            out.writeInt(VERSION);
            out.length = HEAD_LENGTH;
            for (var i:int = 0; i < SECTION_COUNT; i++)
            {
                var key:Fingerprint = keys[i] || new Fingerprint();
                var start:int = out.length;
                if (keys[i] != null && sections[i] != null)
                {
                    out.position = start;
                    out.writeBytes(sections[i]);
                }
                out.position = TABLE_AT + i * ENTRY_LENGTH;
                key.writeTo(out);
                out.writeInt(out.length - start);
            }
            out.length = out.length + 7 & ~7;
            out.position = LENGTH_AT;
            out.writeInt(out.length + Fingerprint.LENGTH);
            var whole:Fingerprint = new Fingerprint();
            out.position = 0;
            whole.addGroups(out, out.length / Fingerprint.LENGTH);
            whole.writeTo(out);
            out.position = 0;
            return out;
        }

        /**
         * The key of a cooked file's model: the fingerprint of the arguments of a load. A cooked file is valid only for these.
         *
         * @param upAxis "x", "y", "z" or a ModelTransform
         * @param scaling as for Model's constructor
         * @param usesTransforms whether the transform file beside the model's file is fetched too
         */
        public static function keyOfLoad(upAxis:Object, scaling:String, usesTransforms:Boolean):Fingerprint
        {
            // join() calls the transform's toString()
            return Fingerprint.of([upAxis, scaling, upAxis is String && usesTransforms].join());
        }

        /** An empty ByteArray in the byte order of cooked files. */
        public static function newBytes():ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            return bytes;
        }

        /** Whether the file is complete, and a section has a key. */
        public function hasKey(index:int, key:Fingerprint):Boolean
        {
            _bytes.position = TABLE_AT + ENTRY_LENGTH * index;
            return _isComplete && key.readAndCompare(_bytes);
        }

        /**
         * The bytes of a section. Their position is 0.
         *
         * @param index the section
         * @param key the key that the section must have; null for any
         * @return null if the section is empty or has another key
         */
        public function section(index:int, key:Fingerprint):ByteArray
        {
            var length:int = _isComplete ? lengthOf(index) : 0;
            if (length == 0 || key != null && !hasKey(index, key))
            {
                return null;
            }
            var start:int = HEAD_LENGTH;
            for (var i:int = 0; i < index; i++)
            {
                start += lengthOf(i);
            }
            var bytes:ByteArray = newBytes();
            bytes.writeBytes(_bytes, start, length);
            bytes.position = 0;
            return bytes;
        }

        /** Whether the file that these bytes are has other sections. A file that is missing or damaged counts as one without sections. */
        public function isChangedBy(bytes:ByteArray):Boolean
        {
            var sealAt:int = bytes.length - Fingerprint.LENGTH;
            var isChanged:Boolean = _isComplete ? bytes.length != _bytes.length : sealAt > HEAD_LENGTH;
            for (var i:int = sealAt; i < bytes.length && _isComplete && !isChanged; i++)
            {
                isChanged = bytes[i] != _bytes[i];
            }
            return isChanged;
        }

        private function lengthOf(index:int):int
        {
            _bytes.position = TABLE_AT + ENTRY_LENGTH * index + Fingerprint.LENGTH;
            return _bytes.readInt();
        }

        private function check(isSealed:Boolean):void
        {
            var rest:Number = _bytes.length - HEAD_LENGTH - Fingerprint.LENGTH;
            for (var i:int = 0; i < SECTION_COUNT; i++)
            {
                var length:int = lengthOf(i);
                rest = length < 0 ? NaN : rest - length;
            }
            _isComplete = isSealed && rest >= 0 && rest < Fingerprint.LENGTH;
        }
    }
}
