package starlogo.models
{
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.IOErrorEvent;
    import flash.events.ProgressEvent;
    import flash.events.SecurityErrorEvent;
    import flash.net.URLLoader;
    import flash.net.URLLoaderDataFormat;
    import flash.net.URLRequest;
    import flash.utils.ByteArray;
    import starlogo.steps.Steps;

    /** One model on its way through a ModelLoader: fetched, read, normalised, and taken in by the receiver. */
    internal final class ModelLoad implements Steps
    {
        // how far along a model is when it is fetched, and when it is read
        private static const FETCHED:Number = 0.2;
        private static const READ:Number = 0.5;

        private var _name:String;
        private var _upAxis:String;
        private var _receiver:ModelReceiver;
        private var _fileName:String = "";
        private var _fetching:URLLoader = null;
        private var _fetched:Number = 0;
        private var _problem:String = null;
        private var _bytes:ByteArray = null;
        private var _text:String = null;
        private var _reader:ModelReader = null;
        private var _isReading:Boolean = true;
        private var _model:Model = null;
        private var _receiving:Steps = null;

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

        /** Whether its file is there, or won't come. */
        public function get isReady():Boolean
        {
            return _fetching == null;
        }

        /** How far along it is, from 0 to 1. */
        public function get progress():Number
        {
            if (_model != null)
            {
                return READ;
            }
            return _reader == null ? FETCHED * _fetched : FETCHED + (READ - FETCHED) * _reader.progress;
        }

        /** Starts to fetch the file. */
        public function fetch(url:String):void
        {
            if (url == null || url == "")
            {
                _problem = "there is no address to fetch its file from";
                return;
            }
            _fileName = url.replace(/[?#].*$/, "");
            _fetching = new URLLoader();
            _fetching.dataFormat = URLLoaderDataFormat.BINARY;
            _fetching.addEventListener(Event.COMPLETE, onFetched);
            _fetching.addEventListener(ProgressEvent.PROGRESS, onProgress);
            _fetching.addEventListener(IOErrorEvent.IO_ERROR, onFetchError);
            _fetching.addEventListener(SecurityErrorEvent.SECURITY_ERROR, onFetchError);
            try
            {
                _fetching.load(new URLRequest(url));
            }
            catch (error:SecurityError)
            {
                _problem = "its file may not be fetched: " + error.message;
                stopListening();
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

        /** Stops fetching. */
        public function cancel():void
        {
            if (_fetching != null)
            {
                var loader:URLLoader = _fetching;
                stopListening();
                loader.close();
            }
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            if (_problem != null)
            {
                throw new ModelError(_name, "", _problem);
            }
            if (_text == null)
            {
                _text = isArchive ? ModelFile.colladaText(_name, _bytes) : ModelFile.text(_name, _bytes);
                _bytes = null;
            }
            else if (_reader == null)
            {
                _reader = isCollada ? new ColladaReader(_name, _text) : new ObjReader(_name, _text, _upAxis);
            }
            else if (_isReading)
            {
                _isReading = _reader.step();
            }
            else if (_model == null)
            {
                _model = new Model(_name, _reader.vertices, _reader.triangles);
            }
            else if (_receiving == null)
            {
                _receiving = _receiver.receive(_model);
            }
            else
            {
                return _receiving.step();
            }
            return true;
        }

        private function get isArchive():Boolean
        {
            return _bytes != null && ZipArchive.isArchive(_bytes);
        }

        /** What begins with a tag is no OBJ file, whatever its name. */
        private function get isCollada():Boolean
        {
            return /^﻿?\s*</.test(_text.substr(0, 1000)) || /\.(dae|zae)$/i.test(_fileName);
        }

        private function onProgress(event:ProgressEvent):void
        {
            _fetched = event.bytesTotal > 0 ? Math.min(1, event.bytesLoaded / event.bytesTotal) : 0;
        }

        private function onFetched(event:Event):void
        {
            _bytes = _fetching.data;
            _fetched = 1;
            stopListening();
        }

        private function onFetchError(event:ErrorEvent):void
        {
            _problem = "its file can't be fetched: " + event.text;
            stopListening();
        }

        private function stopListening():void
        {
            _fetching.removeEventListener(Event.COMPLETE, onFetched);
            _fetching.removeEventListener(ProgressEvent.PROGRESS, onProgress);
            _fetching.removeEventListener(IOErrorEvent.IO_ERROR, onFetchError);
            _fetching.removeEventListener(SecurityErrorEvent.SECURITY_ERROR, onFetchError);
            _fetching = null;
        }
    }
}
