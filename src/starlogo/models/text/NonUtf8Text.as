package starlogo.models.text
{
    import flash.utils.ByteArray;

    /**
     * Decodes bytes that are not UTF-8, with the same result in every player. Adobe's VM alone cannot read these encodings.
     *
     * @private
     */
    public final class NonUtf8Text
    {
        private static const CHUNK:int = 4096;

        // The characters of windows-1252 at 0x80 to 0x9f, where ISO 8859-1 has control characters. A byte that windows-1252 does not define stands
        // for itself.
        private static const WINDOWS:Vector.<int> = new <int>[0x20ac, 0x81, 0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030,
                0x0160, 0x2039, 0x0152, 0x8d, 0x017d, 0x8f, 0x90, 0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014, 0x02dc, 0x2122,
                0x0161, 0x203a, 0x0153, 0x9d, 0x017e, 0x0178];

        /** Decodes UTF-16. An odd last byte is ignored. */
        public static function utf16(bytes:ByteArray, isLowFirst:Boolean):String
        {
            var units:Array = [];
            var low:int = isLowFirst ? 0 : 1;
            for (var i:int = 1; i < bytes.length; i += 2)
            {
                units.push(bytes[int(i - 1 + low)] | bytes[int(i - low)] << 8);
            }
            return textOf(units);
        }

        /** Decodes one byte per character: windows-1252 or ISO 8859-1. */
        public static function latin(bytes:ByteArray, isWindows:Boolean):String
        {
            var units:Array = [];
            for (var i:int = 0; i < bytes.length; i++)
            {
                var unit:int = bytes[i];
                units.push(isWindows && unit >= 0x80 && unit < 0xa0 ? WINDOWS[unit - 0x80] : unit);
            }
            return textOf(units);
        }

        // The player ends a text at its first zero character.
        private static function textOf(units:Array):String
        {
            var end:int = units.indexOf(0);
            var length:int = end < 0 ? units.length : end;
            var parts:Array = [];
            for (var from:int = 0; from < length; from += CHUNK)
            {
                parts.push(String.fromCharCode.apply(null, units.slice(from, Math.min(length, from + CHUNK))));
            }
            return parts.join("");
        }
    }
}
