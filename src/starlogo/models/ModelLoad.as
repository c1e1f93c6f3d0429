package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.collada.ColladaReader;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.argumentsFingerprint;
    import starlogo.models.gltf.GltfFile;
    import starlogo.models.gltf.GltfReader;
    import starlogo.models.obj.ObjReader;
    import starlogo.models.stl.StlReader;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * One model in a ModelLoader. It is fetched, read, normalised and given to the receiver. A step throws a ModelError if the file did not
     * arrive or is no model. The receiver's steps may throw other errors.
     */
    internal final class ModelLoad extends StepSequence
    {
        // the progress of a model when its file has arrived, and when it is read
        private static const FETCHED:Number = 0.2;
        private static const READ:Number = 0.5;

        // The address of a file: its path, and what comes after. No file can be beside a "data:" or "blob:" address.
        private static const FILE:RegExp = /^(?!data:|blob:)([^?#]+)(.*)$/i;
        private static const EXTENSION:RegExp = /\.[^.\/]*$/;

        /** The model's name. */
        public var name:String;

        /** The model; null until it is read. */
        public var model:Model = null;

        /**
         * <code>function(model:Model, problem:Error):void</code>, called when the load is over. One argument is set; after a cancel both
         * are null.
         */
        public var whenOver:Function = null;

        private var _upAxis:Object;
        private var _scaling:String;
        private var _receiver:ModelReceiver;
        private var _url:String = null;

        // the download of the file, the download of its transform, and all downloads that may be running, including buffers
        private var _fetch:ModelFetch = null;
        private var _transform:ModelFetch = null;
        private var _fetches:Vector.<ModelFetch> = new Vector.<ModelFetch>();

        private var _manifest:ModelManifest = null;
        private var _usesTransforms:Boolean = false;
        private var _cooked:CookedLoad = null;
        private var _bytes:ByteArray = null;
        private var _newLoader:Function;
        private var _gltf:GltfFile = null;
        private var _text:String = null;
        private var _format:String = null;
        private var _reader:ModelReader = null;
        private var _source:ModelSource = null;
        private var _shape:NormalisedShape = null;

        /**
         * @param name the model's name
         * @param upAxis the axis that points up, if the file does not say it; or a ModelTransform
         * @param scaling as for Model's constructor
         * @param receiver takes the model
         * @param newLoader <code>function():URLLoader</code>, called for each file
         */
        public function ModelLoad(name:String, upAxis:Object, scaling:String, receiver:ModelReceiver, newLoader:Function)
        {
            _newLoader = newLoader;
            this.name = name;
            _upAxis = upAxis;
            _scaling = scaling;
            _receiver = receiver;
        }

        /** Whether the load can go on: no download is running. */
        public function get isReady():Boolean
        {
            return !_fetches.some(isUnderWay) && (_manifest == null || !_manifest.isUnderWay);
        }

        /** The share of the load that is done, from 0 to 1. */
        public function get progress():Number
        {
            if (model != null)
            {
                return READ;
            }
            if (_reader != null)
            {
                return FETCHED + (READ - FETCHED) * _reader.progress;
            }
            if (_source != null)
            {
                return READ * _source.progress;
            }
            return _fetch == null ? 0 : FETCHED * _fetch.progress;
        }

        /**
         * Starts to fetch the file, or its cooked file.
         *
         * @param url the file's address
         * @param usesTransforms whether the transform file beside it is fetched too
         * @param manifest lists the cooked files; null for no list
         */
        public function fetch(url:String, usesTransforms:Boolean, manifest:ModelManifest):void
        {
            _url = url || "";
            _usesTransforms = usesTransforms && !(_upAxis is ModelTransform);
            if (manifest == null || !FILE.test(_url))
            {
                fetchSource();
                return;
            }
            _manifest = manifest;
            manifest.fetch(_newLoader);
            call(askManifest).begin(tryingCooked).call(useCooked);
        }

        /** Sets the file to read, as bytes or as text. The other is null. */
        public function setFile(bytes:ByteArray, text:String):void
        {
            _bytes = bytes;
            _text = text;
            begin(decoding).call(open);
        }

        /** Sets the source that makes the model instead of a file. */
        public function setSource(source:ModelSource):void
        {
            _source = source;
            add(source).call(keepModel).begin(receiving);
        }

        /** Stops fetching. */
        public function cancel():void
        {
            for each (var each:ModelFetch in _fetches)
            {
                each.cancel();
            }
        }

        private function fetching(url:String):ModelFetch
        {
            var added:ModelFetch = new ModelFetch(url, _newLoader());
            _fetches.push(added);
            return added;
        }

        private function askManifest():void
        {
            var address:String = _manifest.addressFor(_url);
            _manifest = null;
            _fetch = address == null ? null : fetching(address);
        }

        private function tryingCooked():Steps
        {
            _cooked = _fetch == null ? null : new CookedLoad(name, _fetch.bytes, argumentsFingerprint(_upAxis, _scaling, _usesTransforms));
            return _cooked;
        }

        // A cooked file that is missing, damaged or made for other arguments is no error. The source is fetched instead.
        private function useCooked():void
        {
            if (_cooked != null && _cooked.problem == null)
            {
                keepCooked();
                return;
            }
            _cooked = null;
            fetchSource();
        }

        private function keepCooked():void
        {
            model = _cooked.giveTo(new Model(name, Model.ORIGIN));
            _cooked = null;
            _fetch = null;
            begin(receiving);
        }

        private function fetchSource():void
        {
            _fetch = _url == "" ? null : fetching(_url);
            if (_usesTransforms && FILE.test(_url))
            {
                var folder:String = ModelAddress.folderOf(_url);
                var file:String = _url.replace(FILE, "$1").substr(folder.length).replace(EXTENSION, "");
                _transform = file == "" ? null : fetching(folder + file + ".slb" + _url.replace(FILE, "$2"));
            }
            call(checkFetched);
            setFile(null, null);
        }

        private function checkFetched():void
        {
            var problem:String = _fetch == null ? "there is no address to fetch its file from" : _fetch.problem;
            refuseIf(problem != null, name, problem);
            _bytes = _fetch.bytes;
            // without a transform file, or with one that says nothing, the caller's axis stays
            var bytes:ByteArray = _transform == null ? null : _transform.bytes;
            if (bytes != null)
            {
                bytes.position = 0;
                var transform:ModelTransform = ModelTransform.fromText(bytes.readUTFBytes(bytes.length));
                _upAxis = transform.isIdentity ? _upAxis : transform;
            }
        }

        private function decoding():Steps
        {
            if (_bytes != null && CookedFile.isCooked(_bytes))
            {
                _cooked = new CookedLoad(name, _bytes);
            }
            else if (_bytes == null || !GltfFile.isBinary(_bytes) && !StlReader.isBinary(_bytes))
            {
                _text = _text == null ? ModelFile.text(name, _bytes) : _text;
                _bytes = null;
            }
            return _cooked;
        }

        private function open():void
        {
            if (_cooked == null)
            {
                begin(opening).call(fetchBuffers).begin(reading).begin(normalising).call(keepShape).begin(receiving);
                return;
            }
            keepCooked();
        }

        private function opening():Steps
        {
            _format = _bytes == null ? ModelFormat.of(_text, _url) : (GltfFile.isBinary(_bytes) ? ModelFormat.GLTF : ModelFormat.STL);
            _gltf = _format == ModelFormat.GLTF ? new GltfFile(name, _bytes, _text) : null;
            return _gltf;
        }

        // Fetches the files that a glTF file names.
        private function fetchBuffers():void
        {
            var folder:String = ModelAddress.folderOf(_url || "");
            _fetches.length = 0;
            for each (var uri:String in _gltf == null ? null : _gltf.missing)
            {
                if (_url == null || !FILE.test(_url))
                {
                    _gltf.setBuffer(uri, null, "it is in another file, and the address of this file is not known: load() fetches both");
                }
                fetching(folder + uri);
            }
        }

        private function reading():Steps
        {
            _reader = newReader();
            _text = null;
            _bytes = null;
            _fetch = null;
            return _reader;
        }

        private function newReader():ModelReader
        {
            switch (_format)
            {
                case ModelFormat.GLTF:
                    for (var i:int = 0; i < _fetches.length; i++)
                    {
                        _gltf.setBuffer(_gltf.missing[i], _fetches[i].bytes, _fetches[i].problem);
                    }
                    return new GltfReader(name, _gltf, _upAxis as ModelTransform);
                case ModelFormat.STL:
                    return new StlReader(name, _bytes, _text, _upAxis);
                case ModelFormat.COLLADA:
                    return new ColladaReader(name, _text, _upAxis as ModelTransform);
                default:
                    return new ObjReader(name, _text, _upAxis);
            }
        }

        private function normalising():Steps
        {
            _shape = new NormalisedShape(name, _reader.vertices, _reader.triangles, _scaling, _upAxis as ModelTransform, _reader.unit);
            return _shape;
        }

        private function keepShape():void
        {
            model = Model.of(_shape);
            _shape = null;
            _reader = null;
            _gltf = null;
            _fetches.length = 0;
        }

        private function keepModel():void
        {
            model = _source.model;
            _source = null;
        }

        private function receiving():Steps
        {
            return _receiver.receive(model);
        }

        private static function isUnderWay(fetch:ModelFetch, index:int, all:Vector.<ModelFetch>):Boolean
        {
            return fetch.isUnderWay;
        }
    }
}
