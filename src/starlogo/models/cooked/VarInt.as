package starlogo.models.cooked
{
    import flash.utils.ByteArray;

    /**
     * Writes and reads integers of 32 bits in as few bytes as they need. An integer n is written as 2n, or as -2n - 1 if it is
     * negative. A byte holds seven bits of that, the lowest first. The eighth bit says that more bytes follow.
     *
     * @private
     */
    public final class VarInt
    {
        /** Writes a number. */
        public static function write(value:int, out:ByteArray):void
        {
            var rest:uint = value << 1 ^ value >> 31;
            while (rest > 0x7F)
            {
                out.writeByte(rest & 0x7F | 0x80);
                rest >>>= 7;
            }
            out.writeByte(rest);
        }

        /** Reads the next number. @throws EOFError if there is none */
        public static function read(bytes:ByteArray):int
        {
            var byte:int = bytes.readUnsignedByte();
            var value:int = byte & 0x7F;
            for (var shift:int = 7; byte > 0x7F && shift < 32; shift += 7)
            {
                byte = bytes.readUnsignedByte();
                value |= (byte & 0x7F) << shift;
            }
            return value >>> 1 ^ -(value & 1);
        }
    }
}
