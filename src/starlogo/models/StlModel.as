package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.stl.StlReader;

    /**
     * A model from an STL file, as programs for 3D printing write them: binary, or text.
     *
     * <p>Which of both a file is, its length decides, and not the word "solid" that some binary ones begin with too. All solids of a file
     * together make the model. Vertices at equal positions are one, since the format repeats them for each triangle; normals and attributes
     * are passed over. Cost: linear in the file.</p>
     */
    public class StlModel extends Model
    {
        /**
         * The model comes from <code>fromBytes()</code>; the constructor serves that.
         *
         * @param name what agents call the shape, not empty
         * @param bytes the whole file; its position and endianness are left anyhow
         * @param upAxis the axis that points up in the file, "x", "y" or "z", or a ModelTransform
         * @param scaling as for <code>Model</code>
         * @throws ModelError as <code>fromBytes()</code> does
         */
        public function StlModel(name:String, bytes:ByteArray, upAxis:Object = "z", scaling:String = Model.FOOTPRINT)
        {
            super(name, ORIGIN);
            var isBinary:Boolean = bytes != null && bytes.length <= ModelLimits.BYTES && StlReader.isBinary(bytes);
            var text:String = isBinary ? null : ModelFile.text(name, bytes, "STL");
            setShape(new StlReader(name, isBinary ? bytes : null, text, upAxis).readShape(scaling, upAxis as ModelTransform));
        }

        /**
         * Reads a model from a file's bytes.
         *
         * @param name what agents call the shape, not empty
         * @param bytes the whole file; its position and endianness are left anyhow
         * @param upAxis the axis that points up in the file, "x", "y" or "z": STL files do not say; or a ModelTransform
         * @param scaling as for <code>Model</code>
         * @throws ModelError if it is no STL file or has no triangle, is cut off, a number is wrong or not finite, or as for
         *     <code>Model</code>; it names the line or the triangle
         */
        public static function fromBytes(name:String, bytes:ByteArray, upAxis:Object = "z", scaling:String = Model.FOOTPRINT):StlModel
        {
            return new StlModel(name, bytes, upAxis, scaling);
        }
    }
}
