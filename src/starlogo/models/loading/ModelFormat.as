package starlogo.models.loading
{
    import flash.utils.ByteArray;
    import starlogo.models.ModelTransform;
    import starlogo.models.building.ModelReader;
    import starlogo.models.collada.ColladaDocument;
    import starlogo.models.collada.ColladaReader;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.CookedReader;
    import starlogo.models.gltf.GltfFile;
    import starlogo.models.gltf.GltfReader;
    import starlogo.models.obj.ObjReader;
    import starlogo.models.stl.StlReader;
    import starlogo.models.text.TextWords;

    /**
     * Detects the format of a file from its content, and makes its reader. If the content does not tell, the file's name does.
     *
     * @private
     */
    public final class ModelFormat
    {
        private static const COOKED:String = "cooked";
        private static const OBJ:String = "obj";
        private static const COLLADA:String = "dae";
        private static const GLTF:String = "gltf";
        private static const STL:String = "stl";

        private static const HEAD_LENGTH:int = 10000;
        private static const TAG:RegExp = /^\s*</;
        private static const VERTEX:RegExp = /[\n\r][ \t]*v[ \t]+[\-+.\d]/;
        private static const EXTENSION:RegExp = /^[^?#]*\.(obj|dae|gltf|stl)([?#]|$)/i;

        /** The format of a file in a binary form; null if the bytes are in none. */
        public static function ofBytes(bytes:ByteArray):String
        {
            return CookedFile.isCookedFile(bytes) ? COOKED : (GltfFile.isBinary(bytes) ? GLTF : (StlReader.isBinary(bytes) ? STL : null));
        }

        /**
         * The reader of a file.
         *
         * @param name the model's name
         * @param bytes the file
         * @param text its text, null if it is binary
         * @param url the file's address; null if it has none
         * @param upAxis the axis that points up, if the file does not say it; or a ModelTransform
         * @param scaling as for Model's constructor
         * @param fetch gives the other files that a glTF file names: see GltfFile
         */
        public static function newReader(name:String, bytes:ByteArray, text:String, url:String, upAxis:Object, scaling:String, fetch:Function):ModelReader
        {
            switch (text == null ? ofBytes(bytes) : ofText(text, url))
            {
                case COOKED:
                    return new CookedReader(name, bytes);
                case STL:
                    return new StlReader(name, bytes, text, upAxis, scaling);
                case COLLADA:
                    return new ColladaReader(new ColladaDocument(name, text), upAxis as ModelTransform, scaling);
                case GLTF:
                    return new GltfReader(new GltfFile(name, bytes, text, fetch), upAxis as ModelTransform, scaling);
                default:
                    return new ObjReader(name, text, upAxis, scaling);
            }
        }

        private static function ofText(text:String, url:String):String
        {
            text = TextWords.withoutByteOrderMark(text);
            if (TAG.test(text.substr(0, 1000)))
            {
                return COLLADA;
            }
            if (GltfFile.isText(text))
            {
                return GLTF;
            }
            if (StlReader.isText(text))
            {
                return STL;
            }
            var named:Array = url == null || VERTEX.test("\n" + text.substr(0, HEAD_LENGTH)) ? null : url.match(EXTENSION);
            return named == null ? OBJ : named[1].toLowerCase();
        }
    }
}
