package starlogo.libraries.cooked
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.geometry.Fingerprint;
    import starlogo.models.cooked.CookedFile;

    /**
     * The list of the entries of a FitStore, with the length of each. It is stored as bytes too.
     *
     * @private
     */
    public final class StoreIndex
    {
        private static const NAME:RegExp = /^[0-9a-f]{32}$/;
        private static const NAME_LENGTH:int = 32;
        private static const ENTRY_LENGTH:int = 40;

        /** The names, the least recently used first. Each has 32 hexadecimal digits. */
        public var names:Vector.<String> = new Vector.<String>();

        private var _lengths:Vector.<int> = new Vector.<int>();

        /** Reads bytes that toBytes made. Returns an empty list if the bytes are no list. */
        public static function read(bytes:ByteArray):StoreIndex
        {
            if (bytes == null || bytes.length % ENTRY_LENGTH != Fingerprint.LENGTH)
            {
                return new StoreIndex();
            }
            bytes.endian = Endian.LITTLE_ENDIAN;
            bytes.position = 0;
            var whole:Fingerprint = new Fingerprint();
            whole.addBytes(bytes, bytes.length / Fingerprint.LENGTH - 1);
            return whole.isNextOf(bytes) ? readEntries(bytes) : new StoreIndex();
        }

        /** The list as bytes. */
        public function toBytes():ByteArray
        {
            var bytes:ByteArray = CookedFile.newBytes();
            for (var i:int = 0; i < names.length; i++)
            {
                bytes.writeUTFBytes(names[i]);
                bytes.writeInt(_lengths[i]);
                bytes.writeInt(0);
            }
            CookedFile.seal(bytes);
            return bytes;
        }

        /** The number of bytes of all entries. */
        public function get total():Number
        {
            var sum:Number = 0;
            for each (var length:int in _lengths)
            {
                sum += length;
            }
            return sum;
        }

        /** Adds an entry, or moves it to the end if it is present. */
        public function put(name:String, length:int):void
        {
            remove(name);
            names.push(name);
            _lengths.push(length);
        }

        /** Removes an entry, if it is present. */
        public function remove(name:String):void
        {
            var at:int = names.indexOf(name);
            if (at >= 0)
            {
                names.splice(at, 1);
                _lengths.splice(at, 1);
            }
        }

        private static function readEntries(bytes:ByteArray):StoreIndex
        {
            var index:StoreIndex = new StoreIndex();
            bytes.position = 0;
            while (bytes.bytesAvailable > Fingerprint.LENGTH)
            {
                var name:String = bytes.readUTFBytes(NAME_LENGTH);
                var length:int = bytes.readInt();
                bytes.readInt();
                if (!NAME.test(name) || length <= 0)
                {
                    return new StoreIndex();
                }
                index.put(name, length);
            }
            return index;
        }
    }
}
