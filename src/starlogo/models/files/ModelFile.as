package starlogo.models.files
{
    import flash.utils.ByteArray;
    import starlogo.models.text.TextWords;

    /**
     * A model's file, given as bytes or as text. The bytes of a text file are decoded once.
     *
     * @private
     */
    public final class ModelFile
    {
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
            _text = text == null ? null : TextWords.withoutByteOrderMark(text);
        }

        /**
         * The file's text, without a byte-order mark.
         *
         * @param expected what a binary file should have been, for the message; null if the format has no binary form
         * @throws ModelError if it is no text
         */
        public function textOf(expected:String = null):String
        {
            if (_text == null)
            {
                _text = FileText.decode(name, bytes, expected);
            }
            return _text;
        }
    }
}
