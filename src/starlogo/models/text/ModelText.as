package starlogo.models.text
{
    import flash.utils.ByteArray;
    import starlogo.models.ModelBudget;
    import starlogo.models.ModelError;
    import starlogo.models.refuseIf;

    /**
     * Decodes the bytes of a model's file into text. It detects the encoding.
     *
     * @private
     */
    public final class ModelText
    {
        private static const HEAD_LENGTH:int = 1024;
        private static const DECLARATION_LENGTH:int = 100;

        /**
         * The text of a file.
         *
         * @param format the format's name for the message, if the format has a binary form too; null otherwise
         * @throws ModelError if the bytes are no text, for example an image
         */
        public static function decode(name:String, bytes:ByteArray, format:String = null):String
        {
            refuseIf(bytes == null || bytes.length == 0, name, "the file is empty");
            checkSize(name, bytes);
            refuseIf(isArchive(bytes), name, "this is a zip archive (.zae is one too): unpack it, and load the model file that is in it");
            return TextWords.withoutByteOrderMark(decoded(name, bytes, format));
        }

        /** Throws if a file has too many bytes. */
        public static function checkSize(name:String, bytes:ByteArray):void
        {
            refuseIf(bytes.length > ModelBudget.BYTES, name, "the file has " + bytes.length + " bytes: expected at most " + ModelBudget.BYTES);
        }

        private static function decoded(name:String, bytes:ByteArray, format:String):String
        {
            var mark:int = bytes.length < 2 ? 0 : bytes[0] << 8 | bytes[1];
            var isLowFirst:Boolean = mark == 0xFFFE || mark == 0x3C00; // a byte-order mark, or a "<" without one
            if (isLowFirst || mark == 0xFEFF || mark == 0x003C)
            {
                return NonUtf8Text.utf16(bytes, isLowFirst);
            }
            bytes.position = 0;
            var text:String = bytes.readUTFBytes(bytes.length);
            checkText(name, bytes, text.length == bytes.length, format);
            bytes.position = 0;
            var start:String = bytes.readUTFBytes(Math.min(bytes.length, DECLARATION_LENGTH));
            var declaration:Array = start.match(/^<\?xml[^>]*encoding=["'](iso-8859-1|windows-1252)["']/i);
            return declaration == null ? text : NonUtf8Text.latin(bytes, declaration[1].toLowerCase() == "windows-1252");
        }

        // A zip archive begins with its first file, or with its end if it has no file.
        private static function isArchive(bytes:ByteArray):Boolean
        {
            return bytes.length >= 4 && bytes[0] == 0x50 && bytes[1] == 0x4B && (bytes[2] == 3 && bytes[3] == 4 || bytes[2] == 5 && bytes[3] == 6);
        }

        // The player ends a text at its first zero character.
        private static function checkText(name:String, bytes:ByteArray, isPlain:Boolean, format:String):void
        {
            var length:int = isPlain ? Math.min(bytes.length, HEAD_LENGTH) : bytes.length;
            for (var i:int = 0; i < length; i++)
            {
                if (bytes[i] == 0)
                {
                    throw new ModelError(name, "", format == null ? "this is a binary file, not text: expected a model"
                            : "this is a binary file, but no " + format + " file");
                }
            }
        }
    }
}
