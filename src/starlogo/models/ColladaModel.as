package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.collada.ColladaScene;
    import starlogo.models.files.ModelFile;

    /**
     * A model from a COLLADA document, version 1.4 or 1.5.
     *
     * <p>The model is the scene that the document shows. All transformations of the nodes are applied. A node may place a geometry directly,
     * through a node of a library, or through a controller. A skin is where its joints put it while nothing moves. If the
     * skin is wrong, or too much for the limits, it is where its bind shape matrix puts it, in its node: what does not move needs no joints.
     * <code>ColladaAnimations</code> refuses it. A morph is its base shape. Every primitive with a surface is read: triangles, polylist, polygons with holes, tristrips and trifans. If a
     * document has no scene, all geometries of its library are read.</p>
     *
     * <p>The document's up axis is turned to z. The reader recognises elements by their names, in any namespace or none. Numbers may have a
     * decimal comma. The unit counts if the model is not scaled (<code>Model.AS_GIVEN</code>). The unit and up axis that single elements have of
     * their own, lights, cameras, splines and solids are ignored. <code>ColladaAnimations</code> has the animations. A reference into another
     * document is an error.</p>
     *
     * <p>Each geometry that a node places is a mesh with the node's name. A material is the one that is bound to the symbol of a primitive, and
     * has its name; if none is bound, the symbol is its name. Names are ids where there are no names. Both are numbered from 0 in the order of
     * the scene.</p>
     *
     * <p>If there are triangles, points that no triangle uses are left out. If there are none, all points of the geometries make a model
     * without triangles. In a mirrored node, the corner order of each triangle is reversed, so that triangles still face outwards.</p>
     *
     * <p>A scene may have a million vertices and two million triangles, and a small file fewer. More is an error, because a small file can
     * ask for any number. Cost: linear in the text and the scene; for concave polygons up to quadratic in their corners.</p>
     */
    public class ColladaModel extends Model
    {
        /**
         * Reads a model. <code>Model</code> says how it is normalised.
         *
         * @param name what agents call the shape, not empty
         * @param text the document's text
         * @param upAxis null for the axis that the document names; "x", "y", "z" or a ModelTransform to use that instead
         * @param scaling as for <code>Model</code>
         * @throws ModelError if the text is no COLLADA document, if its scene has no geometry, if a number, count, index or reference is
         * wrong, if nodes place each other in a circle, or as for <code>Model</code>. The message names the element
         */
        public function ColladaModel(name:String, text:String, upAxis:Object = null, scaling:String = Model.FOOTPRINT)
        {
            super(name, null, null, null, new ColladaScene(new ModelFile(name, null, text), upAxis, scaling).building().build());
        }

        /**
         * Reads a model from a file's bytes: UTF-8, UTF-16, ISO 8859-1 or Windows-1252.
         *
         * @param name what agents call the shape, not empty
         * @param bytes the whole file; its position may change
         * @param upAxis null for the axis that the document names; "x", "y", "z" or a ModelTransform to use that instead
         * @param scaling as for <code>Model</code>
         * @throws ModelError as the constructor; also for a zipped document (.zae), which has to be unpacked first
         */
        public static function fromBytes(name:String, bytes:ByteArray, upAxis:Object = null, scaling:String = Model.FOOTPRINT):ColladaModel
        {
            return new ColladaModel(name, new ModelFile(name, bytes).requireText(), upAxis, scaling);
        }
    }
}
