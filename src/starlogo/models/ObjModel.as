package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.files.ModelFile;
    import starlogo.models.obj.ObjReader;

    /**
     * A model from Wavefront OBJ text.
     *
     * <p>The reader takes vertices (<code>v</code>) and faces (<code>f</code>), in any order. A weight or colours after a vertex's coordinates are
     * ignored. A face's corner may be written <code>1</code>, <code>1/2</code>, <code>1//3</code> or <code>1/2/3</code>. Positive indices count
     * from the first vertex. Negative indices count back from the latest vertex. All groups and objects together make the model. Polygons may be
     * concave. Comments, continued lines, all line ends, tabs, a byte-order mark and decimal commas are understood. Each name after
     * <code>usemtl</code> is a material, and each name after <code>o</code> or <code>g</code> a mesh, numbered from 0 in this order. The latest
     * counts for a face. Everything else is ignored: texture coordinates, normals, material libraries, lines, points, curves, and faces of fewer
     * than three corners.</p>
     *
     * <p>If there are triangles, vertices that no triangle uses are left out. If there are none, all vertices make a model without triangles. Cost:
     * linear in the text; for concave polygons up to quadratic in their corners.</p>
     */
    public class ObjModel extends Model
    {
        /**
         * Reads a model. <code>Model</code> says how it is normalised.
         *
         * @param name what agents call the shape, not empty
         * @param text the file's text
         * @param upAxis the axis that points up in the file: "x", "y" or "z", because OBJ files do not say; or a ModelTransform
         * @param scaling as for <code>Model</code>
         * @throws ModelError if the text is no OBJ file or has no vertex, if a number or an index is wrong, or as for <code>Model</code>.
         * The message names the line
         */
        public function ObjModel(name:String, text:String, upAxis:Object = "z", scaling:String = Model.FOOTPRINT)
        {
            super(name, null, null, null, new ObjReader(new ModelFile(name, null, text), upAxis, scaling).building().build());
        }

        /**
         * Reads a model from a file's bytes: text in UTF-8, or in UTF-16 with a byte-order mark.
         *
         * @param name what agents call the shape, not empty
         * @param bytes the whole file; its position may change
         * @param upAxis the axis that points up in the file: "x", "y" or "z"; or a ModelTransform
         * @param scaling as for <code>Model</code>
         * @throws ModelError as the constructor
         */
        public static function fromBytes(name:String, bytes:ByteArray, upAxis:Object = "z", scaling:String = Model.FOOTPRINT):ObjModel
        {
            return new ObjModel(name, new ModelFile(name, bytes).requireText(), upAxis, scaling);
        }
    }
}
