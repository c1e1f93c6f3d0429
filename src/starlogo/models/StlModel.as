package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.files.ModelFile;
    import starlogo.models.stl.StlReader;

    /**
     * A model from an STL file, the format of 3D printing, as binary or as text.
     *
     * <p>The file's length decides whether it is binary or text, because some binary files begin with the word "solid" too. All solids of a
     * file together make the model. Vertices at equal positions become one, because the format repeats each vertex for every triangle.
     * Normals and attributes are ignored. Text may have decimal commas. Cost: linear in the file.</p>
     */
    public class StlModel extends Model
    {
        /**
         * Use <code>fromBytes()</code> instead.
         *
         * @copy #fromBytes()
         */
        public function StlModel(name:String, bytes:ByteArray, upAxis:Object = "z", scaling:String = Model.FOOTPRINT)
        {
            super(name, null, null, null, new StlReader(new ModelFile(name, bytes), upAxis, scaling).building().build());
        }

        /**
         * Reads a model from a file's bytes.
         *
         * @param name what agents call the shape, not empty
         * @param bytes the whole file; its position and endianness may change
         * @param upAxis the axis that points up in the file: "x", "y" or "z", because STL files do not say; or a ModelTransform
         * @param scaling as for <code>Model</code>
         * @throws ModelError if the file is no STL file, has no triangle or is cut off, if a number is wrong or not finite, or as for
         * <code>Model</code>. The message names the line or the triangle
         */
        public static function fromBytes(name:String, bytes:ByteArray, upAxis:Object = "z", scaling:String = Model.FOOTPRINT):StlModel
        {
            return new StlModel(name, bytes, upAxis, scaling);
        }
    }
}
