package starlogo.models.zip
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.models.refuseIf;

    /**
     * The files in a zip archive (PKWARE, APPNOTE.TXT), stored or deflated. Encrypted archives, split archives and archives above 4 GB are
     * errors.
     *
     * @private
     */
    public final class ZipArchive
    {
        // stands before every key, because a file may be called "hasOwnProperty"
        private static const PREFIX:String = ":";

        private static const LOCAL_HEADER:uint = 0x04034B50;
        private static const CENTRAL_HEADER:uint = 0x02014B50;
        private static const END_OF_DIRECTORY:uint = 0x06054B50;
        private static const END_LENGTH:int = 22;
        private static const LONGEST_COMMENT:int = 65535;
        private static const CENTRAL_LENGTH:int = 46;
        private static const LOCAL_LENGTH:int = 30;
        private static const STORED:int = 0;
        private static const DEFLATED:int = 8;

        /** The beginning of each error's text. */
        internal static const PROBLEM:String = "the zip archive can't be read: ";

        /** The paths of the files. */
        public var files:Array = [];

        private var _name:String;
        private var _bytes:ByteArray;
        private var _headers:Object = {}; // the place of a file's header in the directory, by its path

        /**
         * @param name the model's name
         * @param bytes the archive; its endianness is set
         * @throws ModelError if it is damaged
         */
        public function ZipArchive(name:String, bytes:ByteArray)
        {
            _name = name;
            _bytes = bytes;
            _bytes.endian = Endian.LITTLE_ENDIAN;
            readDirectory(findDirectory());
        }

        /** Whether bytes begin like a zip archive. */
        public static function isArchive(bytes:ByteArray):Boolean
        {
            return bytes.length >= 4 && bytes[0] == 0x50 && bytes[1] == 0x4B && bytes[2] == 3 && bytes[3] == 4;
        }

        /** Whether the archive has a file. */
        public function has(path:String):Boolean
        {
            return _headers.hasOwnProperty(PREFIX + path);
        }

        /**
         * Begins to unpack a file of the archive.
         *
         * @param path the file
         * @param most the most bytes that it may have unpacked
         * @throws ModelError if the file is not at the place that the archive gives, is too large, or packed by an unknown method
         */
        public function unpack(path:String, most:int):Inflater
        {
            var header:int = _headers[PREFIX + path];
            var isEncrypted:Boolean = (shortAt(header + 8) & 1) == 1;
            var method:int = shortAt(header + 10);
            var packedSize:uint = wordAt(header + 20);
            var size:uint = wordAt(header + 24);
            var local:uint = wordAt(header + 42);
            refuse(isEncrypted || method != STORED && method != DEFLATED, path + " is encrypted or packed in a way other than \"deflate\"");
            refuse(size > most, path + " has " + size + " bytes unpacked: expected at most " + most);
            refuse(!isWithin(local, LOCAL_LENGTH) || wordAt(local) != LOCAL_HEADER, path + " is not where the archive says");
            var start:Number = local + LOCAL_LENGTH + shortAt(local + 26) + shortAt(local + 28);
            refuse(!isWithin(start, packedSize), path + " is cut off");
            var packed:ByteArray = new ByteArray();
            if (packedSize > 0)
            {
                packed.writeBytes(_bytes, start, packedSize);
            }
            return new Inflater(_name, path, packed, method == DEFLATED, size);
        }

        /** The place of the record at the archive's end. A comment may follow it, so it is searched for backwards. */
        private function findDirectory():int
        {
            var last:int = _bytes.length - END_LENGTH;
            var first:int = Math.max(0, last - LONGEST_COMMENT);
            while (last >= first && !(_bytes[last] == 0x50 && wordAt(last) == END_OF_DIRECTORY))
            {
                last--;
            }
            refuse(last < first, "it is cut off: its directory is missing");
            return last;
        }

        private function readDirectory(end:int):void
        {
            var count:int = shortAt(end + 10);
            var header:Number = wordAt(end + 16);
            for (var i:int = 0; i < count; i++)
            {
                var which:String = " at file " + (i + 1) + " of " + count;
                refuse(!isWithin(header, CENTRAL_LENGTH) || wordAt(header) != CENTRAL_HEADER, "its directory is damaged" + which);
                var pathLength:int = shortAt(header + 28);
                var length:int = CENTRAL_LENGTH + pathLength + shortAt(header + 30) + shortAt(header + 32);
                refuse(!isWithin(header, length), "its directory is cut off" + which);
                _bytes.position = header + CENTRAL_LENGTH;
                var path:String = _bytes.readUTFBytes(pathLength);
                files.push(path);
                _headers[PREFIX + path] = int(header);
                header += length;
            }
        }

        private function refuse(isWrong:Boolean, problem:String):void
        {
            refuseIf(isWrong, _name, PROBLEM + problem);
        }

        private function isWithin(start:Number, length:Number):Boolean
        {
            return start + length <= _bytes.length;
        }

        private function shortAt(position:int):int
        {
            _bytes.position = position;
            return _bytes.readUnsignedShort();
        }

        private function wordAt(position:int):uint
        {
            _bytes.position = position;
            return _bytes.readUnsignedInt();
        }
    }
}
