package starlogo.models
{
    import flash.utils.ByteArray;

    /** The list of the cooked files of a folder and those below it, fetched when it is first asked for. */
    internal final class ModelManifest
    {
        /** Where it is. */
        public var url:String;

        private var _fetch:ModelFetch = null;
        private var _models:Object = null;

        /**
         * @param url where it is
         */
        public function ModelManifest(url:String)
        {
            this.url = url;
        }

        /** Fetches it unless that was begun before. @param newLoader <code>function():URLLoader</code> */
        public function fetch(newLoader:Function):void
        {
            _fetch ||= new ModelFetch(url, newLoader());
        }

        /** Whether it is being fetched. */
        public function get isUnderWay():Boolean
        {
            return _fetch.isUnderWay;
        }

        /** Where the cooked file of a model's file is; null if it names none. */
        public function addressFor(file:String):String
        {
            var parts:Array = file.match(/^([^?#]*)(.*)$/);
            var folder:String = url.match(/^([^?#]*\/)?/)[0];
            if (parts[1].substr(0, folder.length) != folder)
            {
                return null;
            }
            _models ||= read(_fetch.bytes);
            var name:String = parts[1].substr(folder.length);
            var entry:Object = entryOf(_models, name);
            var cooked:Object = entry == null ? null : entry["cooked"];
            return cooked is String && cooked != "" ? folder + cooked + parts[2] : null;
        }

        // What is none names nothing.
        private static function read(bytes:ByteArray):Object
        {
            var models:Object = null;
            try
            {
                bytes.position = 0;
                models = JSON.parse(bytes.readUTFBytes(bytes.length)).models;
            }
            catch (error:Error)
            {
                models = null; // it was not fetched, or is no JSON
            }
            return models || new Object();
        }
    }
}
