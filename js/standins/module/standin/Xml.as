package standin
{
    /** Reads XML where there is no E4X; xml.mjs has what it does. */
    public final class Xml
    {
        /**
         * The root element of a document, or null: its name, attributes by name, children, texts and parent.
         *
         * @throws TypeError if it is not well-formed
         */
        public static native function parse(source:String):Object;
    }
}
