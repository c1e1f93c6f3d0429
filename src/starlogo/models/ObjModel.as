package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.obj.ObjReader;

    /**
     * A model from Wavefront OBJ text.
     *
     * <p>Read are vertices (<code>v</code>; a weight or colours after the coordinates are passed over) and faces
     * (<code>f</code>, in each of the forms <code>1</code>, <code>1/2</code>, <code>1//3</code>, <code>1/2/3</code>,
     * counted from the first vertex or, negative, back from the latest one), in any order; all groups and objects
     * together make the model. Polygons may be concave. Comments, continued lines, any line ends, tabs, a byte-order
     * mark and decimal commas are understood. Everything else (texture coordinates, normals, materials, lines,
     * points, curves, faces of fewer than three corners) has no part in collisions and is passed over.</p>
     *
     * <p>Where a file has faces, vertices that no face uses are left out; where it has none, all vertices make a
     * model without triangles. Cost: linear in the text, and for concave polygons up to quadratic in their
     * corners.</p>
     */
    public class ObjModel extends Model
    {
        /**
         * Reads a model; <code>Model</code> says how it is normalised.
         *
         * @param name what agents call the shape, not empty
         * @param source the file's text
         * @param upAxis the axis that points up in the file, "x", "y" or "z": OBJ files do not say; or a ModelTransform
         * @param scaling as for <code>Model</code>
         * @throws ModelError if the text is no OBJ file or holds no vertex, a number or an index is wrong, or as for
         *     <code>Model</code>; it names the line
         */
        public function ObjModel(name:String, source:String, upAxis:Object = "z", scaling:String = Model.FOOTPRINT)
        {
            super(name, ORIGIN);
            setShape(new ObjReader(name, source, upAxis).readShape(scaling, upAxis as ModelTransform));
        }

        /**
         * Reads a model from a file's bytes: text in UTF-8, or in UTF-16 with a byte-order mark.
         *
         * @param name what agents call the shape, not empty
         * @param bytes the whole file; its position is left anywhere
         * @param upAxis the axis that points up in the file, or a ModelTransform
         * @param scaling as for <code>Model</code>
         * @throws ModelError as the constructor does
         */
        public static function fromBytes(name:String, bytes:ByteArray, upAxis:Object = "z", scaling:String = Model.FOOTPRINT):ObjModel
        {
            return new ObjModel(name, ModelFile.text(name, bytes), upAxis, scaling);
        }
    }
}
