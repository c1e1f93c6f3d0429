package starlogo.models.loading
{
    import flash.utils.ByteArray;
    import starlogo.models.text.FileAddress;

    /**
     * The list of the cooked files in a folder and below. It is fetched when it is first needed.
     *
     * @private
     */
    public final class CookedManifest
    {
        /** The list's address. */
        public var url:String;

        private var _download:FileDownload = null;
        private var _models:Object = null;

        /** @param url the list's address */
        public function CookedManifest(url:String)
        {
            this.url = url;
        }

        /** Fetches the list, if it has not been requested before. @param newLoader <code>function():URLLoader</code> */
        public function fetch(newLoader:Function):void
        {
            _download ||= new FileDownload(url, newLoader());
        }

        /** Whether the download is running. */
        public function get isUnderWay():Boolean
        {
            return _download != null && _download.isUnderWay;
        }

        /** The address of the cooked file for a model's file; null if the list has none, or has not come. */
        public function addressFor(file:String):String
        {
            var parts:Array = file.match(/^([^?#]*)(.*)$/);
            var folder:String = FileAddress.folderOf(url);
            if (parts[1].substr(0, folder.length) != folder)
            {
                return null;
            }
            var bytes:ByteArray = _download == null ? null : _download.bytes;
            if (bytes == null)
            {
                return null;
            }
            _models ||= read(bytes);
            var name:String = parts[1].substr(folder.length);
            var cooked:Object = _models["#" + name];
            // the model's own address may be anywhere, because the game chose it
            var own:String = cooked is String ? String(cooked) : "";
            own = own.indexOf(name) == 0 ? own.substr(name.length) : own;
            return FileAddress.isWithin(own) ? folder + cooked + parts[2] : null;
        }

        // A file that is no list counts as an empty list.
        private static function read(bytes:ByteArray):Object
        {
            var models:Object = {};
            try
            {
                bytes.position = 0;
                var listed:Object = JSON.parse(bytes.readUTFBytes(bytes.length)).models;
                for (var name:String in listed)
                {
                    var entry:Object = listed[name];
                    models["#" + name] = entry != null && entry.hasOwnProperty("cooked") ? entry["cooked"] : null;
                }
            }
            catch (error:Error)
            {
                // it is no JSON
            }
            return models;
        }
    }
}
