package starlogo.models.zip
{
    import flash.utils.ByteArray;
    import starlogo.models.ModelError;
    import starlogo.models.plainMessage;
    import starlogo.steps.StepSequence;

    /**
     * Unpacks one file of a zip archive, in steps. One that might become large is measured before it is unpacked, for the
     * player unpacks in one piece and an archive may claim any size.
     */
    internal final class ZipEntry extends StepSequence
    {
        /** A file that is no larger than this when it is unpacked does no harm; in bytes. */
        internal static const HARMLESS_SIZE:int = 16777216;

        /** The file, when no step is left; the steps throw a ModelError if it is damaged or has another size than it says. */
        public var content:ByteArray;

        private var _name:String;
        private var _path:String;
        private var _size:uint;
        private var _meter:DeflateMeter;

        /**
         * @param name the model's name
         * @param path the file's path in the archive
         * @param packed the file as it is packed; unpacked in place
         * @param isDeflated whether it is deflated, else it is stored as it is
         * @param size how many bytes it says it has unpacked
         */
        public function ZipEntry(name:String, path:String, packed:ByteArray, isDeflated:Boolean, size:uint)
        {
            _name = name;
            _path = path;
            content = packed;
            _size = size;
            if (isDeflated)
            {
                var largest:Number = DeflateMeter.MAX_RATIO * Number(packed.length);
                if (largest > HARMLESS_SIZE && largest > size)
                {
                    _meter = new DeflateMeter(packed, size);
                    repeat(measure).call(checkMeasure);
                }
                call(inflate);
            }
            call(checkSize);
        }

        private function measure():Boolean
        {
            try
            {
                var hasMore:Boolean = _meter.step();
            }
            catch (failure:ArgumentError)
            {
                throw damage(failure);
            }
            return hasMore;
        }

        private function checkMeasure():void
        {
            ZipArchive.refuseIf(_meter.size > _size, _name, _path + " should have " + _size + " bytes unpacked, but has more");
            _meter = null;
        }

        private function inflate():void
        {
            try
            {
                content.inflate();
            }
            catch (failure:Error)
            {
                throw damage(failure);
            }
        }

        private function checkSize():void
        {
            ZipArchive.refuseIf(content.length != _size, _name, _path + " should have " + _size + " bytes unpacked, but has " +
                    content.length);
            content.position = 0;
        }

        private function damage(failure:Error):ModelError
        {
            return ZipArchive.error(_name, _path + " can't be unpacked: " + plainMessage(failure.message));
        }
    }
}
