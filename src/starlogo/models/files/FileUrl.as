package starlogo.models.files
{
    /**
     * The addresses of a model's files. A file may name only files in its own folder, or below it. Browsers drop tabs and line ends, take a
     * backslash for a slash, and decode dots, so addresses are compared without all this.
     *
     * @private
     */
    public final class FileUrl
    {
        private static const LONGEST:int = 2000;
        private static const FOLDER:RegExp = /^([a-z][a-z0-9+.\-]*:)?(\/\/[^\/?#]*)?([^?#]*\/)?/i;

        private static const PATH:RegExp = /^[^?#]*/;

        // No file can be beside such an address.
        private static const WITHOUT_FOLDER:RegExp = /^(data:|blob:|[?#]|$)/i;
        private static const EXTENSION:RegExp = /\.[^.\/]*$/;
        private static const OUTSIDE:RegExp = /[\x00-\x1F\x7F\\]|^[^\/?#]*:|^\s*\/|(^|\/)\s*\.\./;

        /** The part of an address before a "?" or "#". */
        public static function pathOf(url:String):String
        {
            return url.match(PATH)[0];
        }

        /** The part of an address after its path. */
        public static function suffixOf(url:String):String
        {
            return url.substr(pathOf(url).length);
        }

        /** The folder of a file: the part of its address up to the file's name. Empty if it has none. */
        public static function folderOf(url:String):String
        {
            var parts:Array = url.match(FOLDER);
            return parts[0] + (parts[2] && !parts[3] ? "/" : "");
        }

        /** Whether other files can be beside a file. */
        public static function hasFolder(url:String):Boolean
        {
            return url != null && !WITHOUT_FOLDER.test(url);
        }

        /** The address of the file with the same name and another extension, which begins with a dot. Null if the file has no name. */
        public static function siblingOf(url:String, extension:String):String
        {
            var folder:String = folderOf(url);
            var name:String = pathOf(url).substr(folder.length).replace(EXTENSION, "");
            return name == "" ? null : folder + name + extension + suffixOf(url);
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
