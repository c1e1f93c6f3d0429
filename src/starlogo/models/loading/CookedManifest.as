package starlogo.models.loading
{
    import flash.utils.ByteArray;
    import starlogo.data.keyOf;
    import starlogo.models.files.FileUrl;

    /**
     * The list of the cooked files in a folder and below.
     *
     * @private
     */
    public final class CookedManifest
    {
        /** The list's address. Read only. */
        public var url:String;

        /** The download of the list. It begins when it is first needed. */
        public var download:FileDownload = null;

        // The addresses of the cooked files, by those of the models' files. All are relative to the list's folder. Null before they are read.
        private var _cooked:Object = null;

        /** @param url the list's address */
        public function CookedManifest(url:String)
        {
            this.url = url;
        }

        /** The address of the cooked file for a model's file; null if the list has none, or has not come. */
        public function addressFor(file:String):String
        {
            var path:String = FileUrl.pathOf(file);
            var folder:String = FileUrl.folderOf(url);
            if (path.indexOf(folder) != 0 || download == null || download.bytes == null)
            {
                return null;
            }
            _cooked ||= read(download.bytes);
            var model:String = path.substr(folder.length);
            var cooked:String = _cooked[keyOf(model)] || "";
            // A cooked file's address may begin with the model's, which the game chose. Only what the list adds is checked.
            var added:String = cooked.indexOf(model) == 0 ? cooked.substr(model.length) : cooked;
            return FileUrl.isWithin(added) ? folder + cooked + FileUrl.suffixOf(file) : null;
        }

        // A file that is no list counts as an empty list.
        private static function read(bytes:ByteArray):Object
        {
            var all:Object = {};
            try
            {
                bytes.position = 0;
                var listed:Object = JSON.parse(bytes.readUTFBytes(bytes.length)).models;
                for (var model:String in listed)
                {
                    var entry:Object = listed[model];
                    var cooked:Object = entry != null && typeof entry == "object" && "cooked" in entry ? entry["cooked"] : null;
                    all[keyOf(model)] = cooked as String;
                }
            }
            catch (error:Error)
            {
                // it is no JSON
            }
            return all;
        }
    }
}
