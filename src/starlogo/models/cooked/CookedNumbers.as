package starlogo.models.cooked
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;

    /**
     * Whole numbers of 32 bits in as few bytes as they need: twice the number, or of a negative one twice -1 less the number, and 1; seven bits a
     * byte, the lowest first, the eighth bit telling that more follow. And vectors.
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

        /** Writes x, y and z with all bits. */
        public static function writeVector(vector:Vector3D, out:ByteArray):void
        {
            out.writeDouble(vector.x);
            out.writeDouble(vector.y);
            out.writeDouble(vector.z);
        }

        /** The next vector. @throws EOFError if there is none */
        public static function readVector(bytes:ByteArray):Vector3D
        {
            return new Vector3D(bytes.readDouble(), bytes.readDouble(), bytes.readDouble());
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
