package support
{
    import flash.utils.ByteArray;

    /**
     * A text's bytes: in UTF-8, in UTF-16 ("unicode" with the low byte first, "unicodeFFFE" with the high one), or in any other
     * encoding the characters' codes. Adobe's VM has no writeMultiByte.
     */
    public function encoded(text:String, encoding:String = "utf-8"):ByteArray
    {
        var bytes:ByteArray = new ByteArray();
        if (encoding == "utf-8")
        {
            bytes.writeUTFBytes(text);
            return bytes;
        }
        for (var i:int = 0; i < text.length; i++)
        {
            var code:int = text.charCodeAt(i);
            if (encoding == "unicodeFFFE")
            {
                bytes.writeByte(code >> 8);
            }
            bytes.writeByte(code);
            if (encoding == "unicode")
            {
                bytes.writeByte(code >> 8);
            }
        }
        return bytes;
    }
}
