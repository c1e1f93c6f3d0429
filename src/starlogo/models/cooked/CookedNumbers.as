package starlogo.models.cooked
{
    import flash.utils.ByteArray;

    /**
     * Whole numbers of 32 bits in as few bytes as they need: twice the number, or for one below 0 twice what is left of it above -1, and 1; seven
     * bits a byte, the lowest first, the eighth bit telling that more follow.
     *
     * @private
     */
    public final class CookedNumbers
    {
        /** All is static. */
        public function CookedNumbers()
        {
        }

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

        /** The next number. @throws EOFError if there is none */
        public static function read(bytes:ByteArray):int
        {
            return rest(bytes, bytes.readUnsignedByte());
        }

        /** The number of which the first byte is read already. */
        public static function rest(bytes:ByteArray, byte:int):int
        {
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
