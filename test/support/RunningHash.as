package support
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;

    /** One number for a row of numbers, to the last bit: FNV-1a over their bytes. */
    public final class RunningHash
    {
        private var _hash:uint = 2166136261;
        private var _bytes:ByteArray = new ByteArray();

        /** Of no numbers. */
        public function RunningHash()
        {
            _bytes.endian = Endian.LITTLE_ENDIAN;
        }

        /** The hash: eight hexadecimal digits. */
        public function toString():String
        {
            return ("0000000" + _hash.toString(16)).slice(-8);
        }

        /** Adds 24 bits. */
        public function addShort(number:int):void
        {
            addByte(number & 0xff);
            addByte((number >>> 8) & 0xff);
            addByte((number >>> 16) & 0xff);
        }

        /** Adds a Number. What is not a number has many patterns of bits, and counts as one; so do 0 and -0, which are equal. */
        public function addNumber(number:Number):void
        {
            if (isNaN(number))
            {
                addShort(0x7ff8);
                return;
            }
            _bytes.position = 0;
            _bytes.writeDouble(number == 0 ? 0 : number);
            addBytes(_bytes);
        }

        /** Adds bytes, all of them. */
        public function addBytes(bytes:ByteArray):void
        {
            for (var i:int = 0; i < bytes.length; i++)
            {
                addByte(bytes[i]);
            }
        }

        private function addByte(value:int):void
        {
            _hash ^= value;
            // times 16777619, which is 2^24 + 403, within 32 bits
            var low:uint = (_hash & 0xffff) * 403;
            var high:uint = ((_hash >>> 16) * 403) << 16;
            _hash = low + high + (_hash << 24);
        }
    }
}
