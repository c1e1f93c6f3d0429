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
     * <code>fetchCooked</code> and <code>readCooked</code> try the cooked file. If that gives no model, <code>fetchFile</code> fetches the model's own
     * file and its transform file. <code>read</code> decodes the file. <code>addMakeSteps</code> has its reader make the model, which may fetch other
     * files (<code>fetchSibling</code>), and <code>keepModel</code> gives it to the receiver.</p>
     *
     * @private
     */
    public final class ModelLoad extends StepSequence
    {
        // A model that is read has the progress READ_PROGRESS. Fetching its file is the share FETCHING_SHARE of that.
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

        // the addresses of the file and of its transform file; null if there is none to fetch
        private var _url:String = null;
        private var _transformUrl:String = null;

        // the list of cooked files; null if there is none for the file
        private var _manifest:CookedManifest = null;

        // the progress that a cooked file has made that gave no model; 0 if there was none
        private var _cookedProgress:Number = 0;

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
            return !_downloads.some(isRunning) && (_manifest == null || !_manifest.download.isRunning);
        }

        /** The share of the load that is done, from 0 to 1. */
        public function get progress():Number
        {
            if (model != null)
            {
                return READ_PROGRESS;
            }
            var fetching:Number = _url == null ? 0 : FETCHING_SHARE;
            var fetched:Number = _downloads.length == 0 ? 0 : _downloads[0].progress;
            var share:Number = _maker == null ? fetching * fetched : fetching + (1 - fetching) * (Math.max(0, Math.min(_maker.progress, 1)) || 0);
            return _cookedProgress + (READ_PROGRESS - _cookedProgress) * share;
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
            _url = url;
            _transformUrl = usesTransforms && !(_upAxis is ModelTransform) && FileUrl.hasFolder(url) ? FileUrl.siblingOf(url, ".slb") : null;
            if (manifest == null || !FileUrl.hasFolder(url))
            {
                fetchFile();
                return;
            }
            _manifest = manifest;
            manifest.download ||= new FileDownload(manifest.url, _newURLLoader());
            call(fetchCooked);
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
            _maker = maker;
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

        private function fetchCooked():void
        {
            var address:String = _manifest.addressFor(_url);
            if (address == null)
            {
                fetchFile();
                return;
            }
            var file:FileDownload = startDownload(address);
            call(function():void
                {
                    _maker = CookedReader.building(name, file.bytes, CookedFile.keyOfLoad(_upAxis, _scaling, _transformUrl != null));
                }).repeat(readCooked);
        }

        // A cooked file that is missing, damaged or made for other arguments is no error. The model's own file is fetched instead.
        private function readCooked():Boolean
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
                _cookedProgress = progress;
                _maker = null;
                fetchFile();
            }
            return false;
        }

        private function fetchFile():void
        {
            var file:FileDownload = startDownload(_url);
            var transformFile:FileDownload = _transformUrl == null ? null : startDownload(_transformUrl);
            call(function():void
                {
                    readFetched(file, transformFile);
                });
        }

        // Starts to fetch a file. The next step is done when it has come.
        private function startDownload(address:String):FileDownload
        {
            var started:FileDownload = new FileDownload(address, _newURLLoader());
            _downloads.push(started);
            return started;
        }

        private function readFetched(file:FileDownload, transformFile:FileDownload):void
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
            read(new ModelFile(name, file.bytes, null, _url));
        }

        private function read(file:ModelFile):void
        {
            addMakeSteps(ModelFormat.building(file, _upAxis, _scaling, fetchSibling));
        }

        // Starts to fetch a file that the model's file names: see GltfFile. The maker's next step is done when it has come.
        private function fetchSibling(uri:String):Object
        {
            return FileUrl.hasFolder(_url) ? startDownload(FileUrl.folderOf(_url) + uri)
                : {bytes: null, problem: "it is in another file, and the address of this file is not known: load() fetches both"};
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
