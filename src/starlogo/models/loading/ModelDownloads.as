package starlogo.models.loading
{
    import starlogo.models.gltf.GltfFile;
    import starlogo.models.text.ModelAddress;

    /**
     * The downloads for one model: its file, and the files that belong to it. With a list of cooked files, <code>fetchManifest()</code> and
     * then <code>fetchCooked()</code> come first. Then <code>fetchFile()</code>; for a glTF file, <code>fetchBuffers()</code> and
     * <code>giveBuffers()</code>; and <code>release()</code> at the end. The downloads of each must be over before the next call.
     *
     * @private
     */
    public final class ModelDownloads
    {
        // The address of a file: its path, and what comes after. No file can be beside a "data:" or "blob:" address.
        private static const FILE:RegExp = /^(?!data:|blob:)([^?#]+)(.*)$/i;
        private static const EXTENSION:RegExp = /\.[^.\/]*$/;

        /** The file's address; null if it is not known. */
        public var url:String = null;

        /** The file, or its cooked file; null before it is fetched. */
        public var file:ModelDownload = null;

        /** The transform file beside it; null for none. */
        public var transform:ModelDownload = null;

        private var _newLoader:Function;
        private var _manifest:ModelManifest = null;
        private var _all:Vector.<ModelDownload> = new Vector.<ModelDownload>();

        /** @param newLoader <code>function():URLLoader</code>, called for each file */
        public function ModelDownloads(newLoader:Function)
        {
            _newLoader = newLoader;
        }

        /** Whether no download is running. */
        public function get areDone():Boolean
        {
            return !_all.some(isUnderWay) && (_manifest == null || !_manifest.isUnderWay);
        }

        /** Whether files can be beside the file. */
        public function get hasFolder():Boolean
        {
            return url != null && FILE.test(url);
        }

        /** Stops fetching. */
        public function cancel():void
        {
            for each (var each:ModelDownload in _all)
            {
                each.cancel();
            }
        }

        /** Asks for the list of cooked files. */
        public function fetchManifest(manifest:ModelManifest):void
        {
            _manifest = manifest;
            manifest.fetch(_newLoader);
        }

        /** Starts to fetch the cooked file, if the manifest lists one. */
        public function fetchCooked():void
        {
            var address:String = _manifest.addressFor(url);
            _manifest = null;
            file = address == null ? null : download(address);
        }

        /** Starts to fetch the file. @param usesTransforms whether the transform file beside it is fetched too */
        public function fetchFile(usesTransforms:Boolean):void
        {
            file = url == "" ? null : download(url);
            if (usesTransforms && hasFolder)
            {
                var folder:String = ModelAddress.folderOf(url);
                var name:String = url.replace(FILE, "$1").substr(folder.length).replace(EXTENSION, "");
                transform = name == "" ? null : download(folder + name + ".slb" + url.replace(FILE, "$2"));
            }
        }

        /** Starts to fetch the files that a glTF file names. */
        public function fetchBuffers(gltf:GltfFile):void
        {
            _all.length = 0;
            for each (var uri:String in gltf.otherFiles)
            {
                if (!hasFolder)
                {
                    gltf.setBuffer(uri, null, "it is in another file, and the address of this file is not known: load() fetches both");
                }
                download(ModelAddress.folderOf(url) + uri);
            }
        }

        /** Gives the files that have come to the glTF file that names them. */
        public function giveBuffers(gltf:GltfFile):void
        {
            for (var i:int = 0; i < gltf.otherFiles.length; i++)
            {
                gltf.setBuffer(gltf.otherFiles[i], _all[i].bytes, _all[i].problem);
            }
        }

        /** Releases the files that have come. */
        public function release():void
        {
            file = transform = null;
            _all.length = 0;
        }

        private function download(address:String):ModelDownload
        {
            var added:ModelDownload = new ModelDownload(address, _newLoader());
            _all.push(added);
            return added;
        }

        private static function isUnderWay(download:ModelDownload, index:int, all:Vector.<ModelDownload>):Boolean
        {
            return download.isUnderWay;
        }
    }
}
