package starlogo.models.files
{
    import flash.utils.ByteArray;
    import starlogo.models.ModelError;

    /**
     * A model's file, given as bytes or as text. The bytes of a text file are decoded once. Their encoding is detected. Other encodings than
     * UTF-8 are decoded here, because Adobe's VM alone cannot read them.
     *
     * @private
     */
    public final class ModelFile
    {
        /** How much of a file's beginning shows what it is. */
        public static const HEAD_LENGTH:int = 1024;

        private static const DECLARATION_LENGTH:int = 100;
        private static const UNITS_PER_PART:int = 4096;
        private static const TAG:RegExp = /^\s*</;
        private static const WEB_PAGE:RegExp = /^\s*<(!doctype\s+)?html\b/i;

        // The characters of windows-1252 at 0x80 to 0x9f, where ISO 8859-1 has control characters. A byte that windows-1252 does not define stands
        // for itself.
        private static const WINDOWS:Vector.<int> = new <int>[0x20ac, 0x81, 0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030,
                0x0160, 0x2039, 0x0152, 0x8d, 0x017d, 0x8f, 0x90, 0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014, 0x02dc, 0x2122,
                0x0161, 0x203a, 0x0153, 0x9d, 0x017e, 0x0178];

        /** The model's name. Read only. */
        public var name:String;

        /** Null if the file was given as text. Read only. */
        public var bytes:ByteArray;

        /** The file's address. Read only. */
        public var url:String;

        private var _text:String;

        /** Either the bytes or the text are null. The address is null if it is not known. */
        public function ModelFile(name:String, bytes:ByteArray, text:String = null, url:String = null)
        {
            this.name = name;
            this.bytes = bytes;
            this.url = url;
            _text = text == null ? null : withoutByteOrderMark(text);
        }

        /**
         * The file's text, without a byte-order mark.
         *
         * @param expected what a binary file should have been, for the message; null if the format has no binary form
         * @throws ModelError if it is no text, for example an image; or a web page, with which a server may answer if it has no such file
         */
        public function requireText(expected:String = null):String
        {
            if (_text == null)
            {
                refuseModelIf(bytes == null, name, "there is nothing to read: the file's content is null");
                refuseModelIf(bytes.length == 0, name, "the file is empty");
                checkSize();
                refuseModelIf(isArchive(bytes), name, "this is a zip archive (.zae is one too): unpack it, and load the model file that is in it");
                _text = withoutByteOrderMark(decoded(expected));
            }
            refuseModelIf(WEB_PAGE.test(_text.substr(0, HEAD_LENGTH)), name, "this is a web page, not a model: is the address right?");
            return _text;
        }

        /** The text without a byte-order mark at its beginning. */
        public static function withoutByteOrderMark(text:String):String
        {
            return text.charCodeAt(0) == 0xFEFF ? text.substr(1) : text;
        }

        /** Whether the text begins with a tag, as COLLADA does. */
        public function get beginsWithTag():Boolean
        {
            return TAG.test(requireText().substr(0, HEAD_LENGTH));
        }

        /** Throws a ModelError if the file has too many bytes. */
        public function checkSize():void
        {
            refuseModelIf(bytes.length > FileBudget.MAX_BYTES, name, "the file has " + bytes.length + " bytes: expected at most " + FileBudget.MAX_BYTES);
        }

        private function decoded(expected:String):String
        {
            var mark:int = bytes.length < 2 ? 0 : bytes[0] << 8 | bytes[1];
            var isLowFirst:Boolean = mark == 0xFFFE || mark == 0x3C00; // a byte-order mark, or a "<" without one
            if (isLowFirst || mark == 0xFEFF || mark == 0x003C)
            {
                return utf16(bytes, isLowFirst);
            }
            bytes.position = 0;
            var text:String = bytes.readUTFBytes(bytes.length);
            checkText(text, expected);
            var declaration:Array = text.substr(0, DECLARATION_LENGTH).match(/^<\?xml[^>]*encoding=["'](iso-8859-1|windows-1252)["']/i);
            return declaration == null ? text : latin(bytes, declaration[1].toLowerCase() == "windows-1252");
        }

        // A zip archive begins with its first file, or with its end if it has no file.
        private static function isArchive(bytes:ByteArray):Boolean
        {
            return bytes.length >= 4 && bytes[0] == 0x50 && bytes[1] == 0x4B && (bytes[2] == 3 && bytes[3] == 4 || bytes[2] == 5 && bytes[3] == 6);
        }

        // Throws if there is a zero byte, as in binary files. The player ends a text at its first one. A text with a character for each byte has not been
        // ended, so a look at its beginning is enough: other players do not end it.
        private function checkText(text:String, expected:String):void
        {
            var length:int = text.length == bytes.length ? Math.min(bytes.length, HEAD_LENGTH) : bytes.length;
            for (var i:int = 0; i < length; i++)
            {
                if (bytes[i] == 0)
                {
                    throw new ModelError(name, "", expected == null ? "this is a binary file, not text: expected a model"
                            : "this is a binary file, but no " + expected);
                }
            }
        }

        /** Decodes UTF-16, with the same result in every player. An odd last byte is ignored. */
        internal static function utf16(bytes:ByteArray, isLowFirst:Boolean):String
        {
            var units:Array = [];
            var low:int = isLowFirst ? 0 : 1;
            for (var i:int = 1; i < bytes.length; i += 2)
            {
                units.push(bytes[int(i - 1 + low)] | bytes[int(i - low)] << 8);
            }
            return stringOf(units);
        }

        /** Decodes one byte per character: windows-1252 or ISO 8859-1. */
        internal static function latin(bytes:ByteArray, isWindows:Boolean):String
        {
            var units:Array = [];
            for (var i:int = 0; i < bytes.length; i++)
            {
                var unit:int = bytes[i];
                units.push(isWindows && unit >= 0x80 && unit < 0xa0 ? WINDOWS[unit - 0x80] : unit);
            }
            return stringOf(units);
        }

        // The player ends a text at its first zero character.
        private static function stringOf(units:Array):String
        {
            var end:int = units.indexOf(0);
            var length:int = end < 0 ? units.length : end;
            var parts:Array = [];
            for (var from:int = 0; from < length; from += UNITS_PER_PART)
            {
                parts.push(String.fromCharCode.apply(null, units.slice(from, Math.min(length, from + UNITS_PER_PART))));
            }
            return parts.join("");
        }
    }
}
