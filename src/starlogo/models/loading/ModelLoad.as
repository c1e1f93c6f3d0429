package starlogo.models.loading
{
    import flash.utils.ByteArray;
    import starlogo.models.Model;
    import starlogo.models.ModelError;
    import starlogo.models.ModelMaker;
    import starlogo.models.ModelReceiver;
    import starlogo.models.ModelTransform;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.CookedReader;
    import starlogo.models.files.FileUrl;
    import starlogo.models.files.ModelFile;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * One model in a ModelLoader. It is fetched, read, normalised and given to the receiver. A step that starts downloads is the last one until
     * they are over: the loader calls <code>step()</code> only while <code>isReady</code>. A step throws a ModelError if the file did not
     * arrive or is no model. The receiver's steps may throw other errors.
     *
     * <p>Each method adds the steps that come after it. <code>fetch</code> fetches the list of cooked files, if there is one. Then
     * <code>fetchCooked</code> tries the cooked file. If that gives no model, <code>fetchFile</code> fetches the model's own file and its transform file.
     * <code>read</code> decodes the file. <code>addMakeSteps</code> has its reader make the model, which may fetch other files, and <code>keepModel</code>
     * gives it to the receiver.</p>
     *
     * @private
     */
    public final class ModelLoad extends StepSequence
    {
        // The progress of a model that is read. Of what is left until then, fetching a file is this share, and reading it the rest.
        private static const READ_PROGRESS:Number = 0.5;
        private static const FETCHING_SHARE:Number = 0.4;

        /** The model's name. */
        public var name:String;

        /** The model; null until it is read. */
        public var model:Model = null;

        /**
         * <code>function(model:Model, problem:Error):void</code>, called when the load is over; null for none. One argument is set; after a
         * cancel both are null. For the promises of the ES module.
         */
        public var whenOver:Function = null;

        private var _upAxis:Object;
        private var _scaling:String;
        private var _receiver:ModelReceiver;
        private var _newURLLoader:Function;

        // The list of cooked files that is fetched first. Other loads wait for it too, so it is not cancelled. Null for none.
        private var _list:FileDownload = null;

        // the progress at the beginning and at the end of the present stage: fetching a file, or reading it
        private var _stageStart:Number = 0;
        private var _stageEnd:Number = 0;

        // The downloads that the next step waits for: the file and its transform file, or its cooked file; or other files that its reader asks for.
        private var _downloads:Vector.<FileDownload> = new Vector.<FileDownload>();

        // what reads the file, or makes the model instead; null before the file has come, and after the model is made
        private var _maker:ModelMaker = null;

        /**
         * @param name the model's name
         * @param upAxis the axis that points up, if the file does not say it; or a ModelTransform
         * @param scaling as for Model's constructor
         * @param receiver takes the model
         * @param newLoader <code>function():URLLoader</code>, called for each file
         */
        public function ModelLoad(name:String, upAxis:Object, scaling:String, receiver:ModelReceiver, newLoader:Function)
        {
            this.name = name;
            _upAxis = upAxis;
            _scaling = scaling;
            _receiver = receiver;
            _newURLLoader = newLoader;
        }

        /** Whether the load can go on: no download is running. */
        public function get isReady():Boolean
        {
            return !_downloads.some(isRunning) && (_list == null || !_list.isRunning);
        }

        /** The share of the load that is done, from 0 to 1. */
        public function get progress():Number
        {
            var share:Number = _downloads.length == 0 ? 0 : _downloads[0].progress;
            if (_maker != null)
            {
                // a game's own maker may return anything
                share = Math.max(0, Math.min(_maker.progress, 1)) || 0;
            }
            return model == null ? _stageStart + (_stageEnd - _stageStart) * share : READ_PROGRESS;
        }

        /**
         * Starts to fetch the file, or its cooked file.
         *
         * @param url the file's address
         * @param usesTransforms whether the transform file beside it is fetched too
         * @param manifest lists the cooked files; null for no list
         */
        public function fetch(url:String, usesTransforms:Boolean, manifest:CookedManifest):void
        {
            var hasFolder:Boolean = FileUrl.hasFolder(url);
            var transformUrl:String = usesTransforms && hasFolder && !(_upAxis is ModelTransform) ? FileUrl.siblingOf(url, ".slb") : null;
            if (manifest == null || !hasFolder)
            {
                fetchFile(url, transformUrl);
                return;
            }
            _list = manifest.download ||= new FileDownload(manifest.url, _newURLLoader());
            call(function():void
                {
                    fetchCooked(manifest.addressFor(url), url, transformUrl);
                });
        }

        /** Adds the steps that read a file. */
        public function addReadSteps(file:ModelFile):void
        {
            call(function():void
                {
                    read(file);
                });
        }

        /** Adds the steps of what makes the model: the reader of its file, or the game's own maker. */
        public function addMakeSteps(maker:ModelMaker):void
        {
            beginReading(maker);
            add(maker).call(keepModel);
        }

        /** @inheritDoc */
        override public function step():Boolean
        {
            // those that this step has waited for
            _downloads.length = 0;
            return super.step();
        }

        /** Stops fetching. */
        public function cancel():void
        {
            for each (var running:FileDownload in _downloads)
            {
                running.cancel();
            }
        }

        private static function isRunning(download:FileDownload, index:int, all:Vector.<FileDownload>):Boolean
        {
            return download.isRunning;
        }

        // A cooked file that is missing, damaged or made for other arguments is no error. The model's own file is fetched instead.
        // @param address of the cooked file; null if there is none
        private function fetchCooked(address:String, url:String, transformUrl:String):void
        {
            if (address == null)
            {
                fetchFile(url, transformUrl);
                return;
            }
            beginFetching();
            var file:FileDownload = startDownload(address);
            call(function():void
                {
                    beginReading(new CookedReader(name, file.bytes, CookedFile.keyOfLoad(_upAxis, _scaling, transformUrl != null)).building());
                }).repeat(function():Boolean
                {
                    try
                    {
                        if (_maker.step())
                        {
                            return true;
                        }
                        keepModel();
                    }
                    catch (error:ModelError)
                    {
                        fetchFile(url, transformUrl);
                    }
                    return false;
                });
        }

        private function fetchFile(url:String, transformUrl:String):void
        {
            beginFetching();
            var file:FileDownload = startDownload(url);
            var transformFile:FileDownload = transformUrl == null ? null : startDownload(transformUrl);
            call(function():void
                {
                    readFetched(url, file, transformFile);
                });
        }

        private function beginFetching():void
        {
            _stageStart = progress;
            _stageEnd = _stageStart + FETCHING_SHARE * (READ_PROGRESS - _stageStart);
            _maker = null;
        }

        private function beginReading(maker:ModelMaker):void
        {
            _stageStart = _stageEnd;
            _stageEnd = READ_PROGRESS;
            _maker = maker;
        }

        // Starts to fetch a file. The next step is done when it has come.
        private function startDownload(address:String):FileDownload
        {
            var started:FileDownload = new FileDownload(address, _newURLLoader());
            _downloads.push(started);
            return started;
        }

        private function readFetched(url:String, file:FileDownload, transformFile:FileDownload):void
        {
            refuseModelIf(file.problem != null, name, file.problem);
            // without a transform file, or with one that says nothing, the caller's axis stays
            var bytes:ByteArray = transformFile == null ? null : transformFile.bytes;
            if (bytes != null)
            {
                bytes.position = 0;
                var transform:ModelTransform = ModelTransform.fromText(bytes.readUTFBytes(bytes.length));
                _upAxis = transform.isIdentity ? _upAxis : transform;
            }
            read(new ModelFile(name, file.bytes, null, url));
        }

        private function read(file:ModelFile):void
        {
            // starts to fetch a file that this one names: see GltfFile; the maker's next step is done when it has come
            var fetchSibling:Function = function(uri:String):Object
            {
                return FileUrl.hasFolder(file.url) ? startDownload(FileUrl.folderOf(file.url) + uri)
                    : {bytes: null, problem: "it is in another file, and the address of this file is not known: load() fetches both"};
            };
            addMakeSteps(ModelFormat.readerOf(file, _upAxis, _scaling, fetchSibling).building());
        }

        private function keepModel():void
        {
            model = _maker.model;
            _maker = null;
            begin(function():Steps
                {
                    return _receiver.receive(model);
                });
        }
    }
}
