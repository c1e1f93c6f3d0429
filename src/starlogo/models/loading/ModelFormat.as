package starlogo.models.loading
{
    import flash.utils.ByteArray;
    import starlogo.models.ModelTransform;
    import starlogo.models.building.ModelReader;
    import starlogo.models.collada.ColladaScene;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.CookedReader;
    import starlogo.models.files.ModelFile;
    import starlogo.models.gltf.GltfFile;
    import starlogo.models.gltf.GltfScene;
    import starlogo.models.obj.ObjReader;
    import starlogo.models.stl.StlReader;

    /**
     * Detects the format of a file from its content, and chooses its reader. If the content does not tell, the file's name does.
     *
     * @private
     */
    public final class ModelFormat
    {
        private static const VERTEX_SEARCH_LENGTH:int = 10000;
        private static const VERTEX:RegExp = /[\n\r][ \t]*v[ \t]+[\-+.\d]/;
        private static const EXTENSION:RegExp = /^[^?#]*\.(obj|dae|gltf|stl)([?#]|$)/i;

        /**
         * The reader for a file. Decodes a text.
         *
         * @param file the file
         * @param upAxis the axis that points up, if the format has no rule for it; or a ModelTransform
         * @param scaling as for Model's constructor
         * @param fetch gives the other files that a glTF file names: see GltfFile
         */
        public static function readerOf(file:ModelFile, upAxis:Object, scaling:String, fetch:Function):ModelReader
        {
            var transform:ModelTransform = upAxis as ModelTransform;
            if (file.bytes != null && CookedFile.isCookedFile(file.bytes))
            {
                return new CookedReader(file.name, file.bytes);
            }
            switch ((file.bytes == null ? null : ofBytes(file.bytes)) || ofText(file))
            {
                case "stl":
                    return new StlReader(file, upAxis, scaling);
                case "dae":
                    return new ColladaScene(file, transform, scaling);
                case "gltf":
                    return new GltfScene(new GltfFile(file, fetch), transform, scaling);
                default:
                    return new ObjReader(file, upAxis, scaling);
            }
        }

        // The format of a file in a binary form, as its extension is; null if the bytes are in none.
        private static function ofBytes(bytes:ByteArray):String
        {
            return GltfFile.isBinary(bytes) ? "gltf" : (StlReader.isBinary(bytes) ? "stl" : null);
        }

        private static function ofText(file:ModelFile):String
        {
            var text:String = file.requireText();
            if (file.beginsWithTag)
            {
                return "dae";
            }
            if (GltfFile.isText(text) || StlReader.isText(text))
            {
                return GltfFile.isText(text) ? "gltf" : "stl";
            }
            var named:Array = file.url == null || VERTEX.test("\n" + text.substr(0, VERTEX_SEARCH_LENGTH)) ? null : file.url.match(EXTENSION);
            return named == null ? "obj" : named[1].toLowerCase();
        }
    }
}
