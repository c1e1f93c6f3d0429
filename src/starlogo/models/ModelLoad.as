package starlogo.models
{
    import flash.net.URLLoader;
    import flash.utils.ByteArray;
    import flash.utils.getTimer;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** One model on its way through a ModelLoader: fetched, read, normalised, and taken in by the receiver. */
    internal final class ModelLoad implements Steps
    {
        // how far along a model is when it is fetched, and when it is read
        private static const FETCHED:Number = 0.2;
        private static const READ:Number = 0.5;

        // milliseconds that a model that is read waits for its .fits file: it was asked for together with the model's own
        private static const PATIENCE:int = 2000;

        // the address of a file: data:text/plain,... has none beside it
        private static const FILE:RegExp = /^(?!data:|blob:)([^?#]+)(.*)$/i;

        private var _name:String;
        private var _upAxis:String;
        private var _receiver:ModelReceiver;
        private var _url:String = null;
        private var _fetch:ModelFetch = null;
        private var _fitsFetch:ModelFetch = null;
        private var _readTime:int = 0;
        private var _bytes:ByteArray = null;
        private var _document:ArchivedDocument = null;
        private var _text:String = null;
        private var _reader:ModelReader = null;
        private var _source:ModelSource = null;
        private var _shape:NormalisedShape = null;
        private var _model:Model = null;
        private var _work:StepSequence = new StepSequence().begin(unpack).begin(read).begin(normalise).call(takeShape).begin(receive);

        /**
         * @param name the model's name
         * @param upAxis the axis that points up, if it is an OBJ file
         * @param receiver takes the model in
         */
        public function ModelLoad(name:String, upAxis:String, receiver:ModelReceiver)
        {
            _name = name;
            _upAxis = upAxis;
            _receiver = receiver;
        }

        /** The model's name. */
        public function get name():String
        {
            return _name;
        }

        /** The model, from when it is read. */
        public function get model():Model
        {
            return _model;
        }

        /** Whether what it needs next is there, or won't come. */
        public function get isReady():Boolean
        {
            if (_fetch != null && _fetch.isUnderWay)
            {
                return false;
            }
            return _model == null || _fitsFetch == null || !_fitsFetch.isUnderWay || getTimer() - _readTime > PATIENCE;
        }

        /** How far along it is, from 0 to 1. */
        public function get progress():Number
        {
            if (_model != null)
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
         * Starts to fetch the file.
         *
         * @param url where it is
         * @param loader fetches it
         * @param fitsLoader fetches the .fits file beside it; null if none is wanted
         */
        public function fetch(url:String, loader:URLLoader, fitsLoader:URLLoader):void
        {
            _url = url || "";
            if (_url != "")
            {
                _fetch = new ModelFetch(_url, loader);
            }
            if (fitsLoader != null && FILE.test(_url))
            {
                _fitsFetch = new ModelFetch(_url.replace(FILE, "$1.fits$2"), fitsLoader);
            }
        }

        /** Takes a file's bytes. */
        public function takeBytes(bytes:ByteArray):void
        {
            _bytes = bytes;
        }

        /** Takes a file's text. */
        public function takeText(text:String):void
        {
            _text = text;
        }

        /** Takes what makes the model, in place of a file. */
        public function takeSource(source:ModelSource):void
        {
            _source = source;
            _work = new StepSequence().add(source).call(takeModel).begin(receive);
        }

        /** Stops fetching. */
        public function cancel():void
        {
            if (_fetch != null)
            {
                _fetch.cancel();
            }
            if (_fitsFetch != null)
            {
                _fitsFetch.cancel();
            }
        }

        /**
         * @inheritDoc
         *
         * @throws ModelError if the file did not come or is no model; the receiver's steps may throw other errors
         */
        public function step():Boolean
        {
            return _work.step();
        }

        private function unpack():Steps
        {
            if (_fetch != null)
            {
                _bytes = _fetch.bytes;
            }
            checkFetched();
            if (_bytes != null && ZipArchive.isArchive(_bytes))
            {
                _document = new ArchivedDocument(_name, _bytes);
            }
            else if (_text == null)
            {
                _text = ModelFile.text(_name, _bytes);
            }
            _bytes = null;
            return _document;
        }

        private function checkFetched():void
        {
            var problem:String = _fetch == null ? null : _fetch.problem;
            if (_url == "")
            {
                problem = "there is no address to fetch its file from";
            }
            if (problem != null)
            {
                throw new ModelError(_name, "", problem);
            }
        }

        private function read():Steps
        {
            if (_document != null)
            {
                _text = _document.text;
                _document = null;
            }
            _reader = isCollada ? new ColladaReader(_name, _text) : new ObjReader(_name, _text, _upAxis);
            _text = null;
            _fetch = null;
            return _reader;
        }

        private function normalise():Steps
        {
            _shape = new NormalisedShape(_name, _reader.vertices, _reader.triangles);
            return _shape;
        }

        private function takeShape():void
        {
            _model = Model.of(_shape);
            _shape = null;
            _reader = null;
            _readTime = getTimer();
        }

        private function takeModel():void
        {
            _model = _source.model;
            _source = null;
        }

        private function receive():Steps
        {
            if (_fitsFetch == null)
            {
                return _receiver.receive(_model);
            }
            // one that is too late
            _fitsFetch.cancel();
            return FitsReceiver(_receiver).receiveWithFits(_model, _fitsFetch.bytes);
        }

        /** What begins with a tag is no OBJ file, whatever its name. */
        private function get isCollada():Boolean
        {
            var start:int = _text.charCodeAt(0) == 0xFEFF ? 1 : 0; // a byte-order mark
            return /^\s*</.test(_text.substr(start, 1000)) || _url != null && /^[^?#]*\.(dae|zae)([?#]|$)/i.test(_url);
        }
    }
}
