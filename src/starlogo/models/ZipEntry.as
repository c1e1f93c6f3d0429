package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Unpacks one file of a zip archive, in steps. One that might become large is measured before it is unpacked, for the
     * player unpacks in one piece and an archive may claim any size.
     */
    internal final class ZipEntry implements Steps
    {
        /** What is no larger than this when it is unpacked does no harm, in bytes. */
        internal static const HARMLESS_SIZE:int = 16777216;

        private var _name:String;
        private var _path:String;
        private var _size:uint;
        private var _content:ByteArray;
        private var _meter:DeflateMeter;
        private var _work:StepSequence = new StepSequence();

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
            _content = packed;
            _size = size;
            if (isDeflated)
            {
                var largest:Number = DeflateMeter.MAX_RATIO * Number(packed.length);
                if (largest > HARMLESS_SIZE && largest > size)
                {
                    _meter = new DeflateMeter(packed, size);
                    _work.repeat(measure).call(checkMeasure);
                }
                _work.call(inflate);
            }
            _work.call(checkSize);
        }

        /** The file, when no step is left. */
        public function get content():ByteArray
        {
            return _content;
        }

        /**
         * @inheritDoc
         *
         * @throws ModelError if the file is damaged, or has another size than it says
         */
        public function step():Boolean
        {
            return _work.step();
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
            if (_meter.size > _size)
            {
                throw ZipArchive.error(_name, _path + " should have " + _size + " bytes unpacked, but has more");
            }
            _meter = null;
        }

        private function inflate():void
        {
            try
            {
                _content.inflate();
            }
            catch (failure:Error)
            {
                throw damage(failure);
            }
        }

        private function checkSize():void
        {
            if (_content.length != _size)
            {
                throw ZipArchive.error(_name, _path + " should have " + _size + " bytes unpacked, but has " + _content.length);
            }
            _content.position = 0;
        }

        private function damage(failure:Error):ModelError
        {
            return ZipArchive.error(_name, _path + " can't be unpacked: " + failure.message);
        }
    }
}
