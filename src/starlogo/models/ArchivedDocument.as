package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Finds the COLLADA document in a zip archive (.zae) and unpacks it, in steps. */
    internal final class ArchivedDocument implements Steps
    {
        private static const MANIFEST:String = "manifest.xml";
        private static const MAX_MANIFEST:int = 100000;

        private var _name:String;
        private var _bytes:ByteArray;
        private var _archive:ZipArchive = null;
        private var _manifest:ZipEntry = null;
        private var _document:ZipEntry = null;
        private var _text:String = null;
        private var _work:StepSequence = new StepSequence().call(open).begin(unpackManifest).begin(unpackDocument).call(decode);

        /**
         * @param name the model's name
         * @param bytes the archive
         */
        public function ArchivedDocument(name:String, bytes:ByteArray)
        {
            _name = name;
            _bytes = bytes;
        }

        /** The document's text, when no step is left. */
        public function get text():String
        {
            return _text;
        }

        /**
         * @inheritDoc
         *
         * @throws ModelError if the archive is damaged or there is no document in it
         */
        public function step():Boolean
        {
            return _work.step();
        }

        private function open():void
        {
            _archive = new ZipArchive(_name, _bytes);
        }

        private function unpackManifest():Steps
        {
            _manifest = _archive.has(MANIFEST) ? _archive.unpack(MANIFEST) : null;
            return _manifest;
        }

        private function unpackDocument():Steps
        {
            _document = _archive.unpack(documentPath());
            return _document;
        }

        private function decode():void
        {
            _text = ModelFile.text(_name, _document.content);
        }

        /** The document that the manifest names, or else the first one. */
        private function documentPath():String
        {
            if (_manifest != null && _manifest.content.length > MAX_MANIFEST)
            {
                throw ZipArchive.error(_name, MANIFEST + " has more than " + MAX_MANIFEST + " bytes");
            }
            var manifest:String = _manifest == null ? "" : ModelFile.text(_name, _manifest.content);
            // no regular expressions: they may take the square of the time
            for each (var piece:String in manifest.split("<"))
            {
                // what comes after a tag, without its fragment
                var word:String = TextTokens.trimmed(piece.substr(piece.indexOf(">") + 1).split("#")[0]);
                var path:String = unescape(word.indexOf("./") == 0 ? word.substr(2) : word);
                if (_archive.has(path))
                {
                    return path;
                }
            }
            for each (var file:String in _archive.files)
            {
                if (file.substr(-4).toLowerCase() == ".dae")
                {
                    return file;
                }
            }
            throw new ModelError(_name, "", "the archive has no COLLADA document (.dae) in it");
        }
    }
}
