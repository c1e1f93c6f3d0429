package starlogo.models.text
{
    /**
     * The rule for addresses in files: only files in the folder of the file that names them, or below it, are fetched. Browsers drop tabs
     * and line ends, take a backslash for a slash, and decode dots, so addresses are compared without all this.
     *
     * @private
     */
    public final class ModelAddress
    {
        private static const LONGEST:int = 2000;
        private static const FOLDER:RegExp = /^([a-z][a-z0-9+.\-]*:)?(\/\/[^\/?#]*)?([^?#]*\/)?/i;
        private static const OUTSIDE:RegExp = /[\x00-\x1F\x7F\\]|^[^\/?#]*:|^\s*\/|(^|\/)\s*\.\./;

        /** The folder of a file: the part of its address up to the file's name. Empty if it has none. */
        public static function folderOf(url:String):String
        {
            var parts:Array = url.match(FOLDER);
            return parts[0] + (parts[2] && !parts[3] ? "/" : "");
        }

        /** Whether an address, relative to a folder, names a file in the folder or below it. */
        public static function isWithin(address:String):Boolean
        {
            var before:String = "";
            var isInside:Boolean = address != "" && address.length <= LONGEST;
            while (isInside && address != before)
            {
                isInside = !OUTSIDE.test(address);
                before = address;
                address = unescape(address);
            }
            return isInside;
        }
    }
}
