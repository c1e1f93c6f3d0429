package flash.utils
{
    /** The orders of a number's bytes. */
    public final class Endian
    {
        /** The most significant first. */
        public static const BIG_ENDIAN:String = "bigEndian";

        /** The least significant first. */
        public static const LITTLE_ENDIAN:String = "littleEndian";
    }
}
