package starlogo.models.zip
{
    import flash.utils.ByteArray;
    import starlogo.models.ModelError;
    import starlogo.models.ModelFile;
    import starlogo.models.ModelBudget;
    import starlogo.models.TextTokens;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Finds the COLLADA document in a zip archive (.zae) and unpacks it, in steps.
     *
     * @private
     */
    public final class ArchivedDocument extends StepSequence
    {
        private static const MANIFEST:String = "manifest.xml";
        private static const MAX_MANIFEST:int = 100000;

        /**
         * The document's text, when no step is left. The steps throw a ModelError if there is no document, or if the archive is damaged.
         */
        public var text:String = null;

        private var _name:String;
        private var _archive:ZipArchive;
        private var _manifest:Inflater = null;
        private var _document:Inflater = null;

        /**
         * @param name the model's name
         * @param bytes the archive; its endianness is set
         * @throws ModelError if it is damaged
         */
        public function ArchivedDocument(name:String, bytes:ByteArray)
        {
            _name = name;
            _archive = new ZipArchive(name, bytes);
            begin(unpackingManifest).begin(unpackingDocument).call(decode);
        }

        private function unpackingManifest():Steps
        {
            _manifest = _archive.has(MANIFEST) ? _archive.unpack(MANIFEST, MAX_MANIFEST) : null;
            return _manifest;
        }

        private function unpackingDocument():Steps
        {
            _document = _archive.unpack(documentPath(), ModelBudget.BYTES);
            return _document;
        }

        private function decode():void
        {
            text = ModelFile.text(_name, _document.content);
        }

        /** The document that the manifest names. Without a manifest, the first document. */
        private function documentPath():String
        {
            var manifest:String = _manifest == null ? "" : ModelFile.text(_name, _manifest.content);
            // no regular expressions, because they may take quadratic time
            for each (var piece:String in manifest.split("<"))
            {
                // the text after a tag, without its fragment
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
