package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.collada.ColladaReader;

    /**
     * A model from a COLLADA document, 1.4 or 1.5.
     *
     * <p>Read is the scene that the document shows: its nodes with all their transformations, the geometries that
     * they place (directly, through nodes of a library, or through controllers: a skin at rest, where its bind shape
     * matrix puts it, and a morph as its base), and of these every primitive with a surface: triangles, polylist,
     * polygons with holes, tristrips and trifans. A document without a scene gives all geometries of its library. The
     * axis that points up is turned to z. Elements are known by their names, in any namespace or none; numbers may
     * have a decimal comma. The unit plays no part, since a model is scaled anyway; nor do materials, lights,
     * cameras, animations, splines and solids.</p>
     *
     * <p>Where there are surfaces, points that none of them uses are left out; where there are none, the points of
     * the geometries make a model without triangles. Triangles of a mirrored node are turned round, so that they
     * still face outwards. A scene may have 50,000 nodes, a million vertices and two million triangles; more is an
     * error, for a small file can ask for any number. Cost: linear in the text and the scene, and for concave
     * polygons up to quadratic in their corners.</p>
     */
    public class ColladaModel extends Model
    {
        /**
         * Reads a model; <code>Model</code> says how it is normalised.
         *
         * @param name what agents call the shape, not empty
         * @param source the document's text
         * @param upAxis null for the axis that the document says; "x", "y", "z" or a ModelTransform in place of that
         * @param scaling as for <code>Model</code>
         * @throws ModelError if the text is no COLLADA document or its scene has no geometry, a number, count, index
         *     or reference is wrong, nodes place each other in a circle, or as for <code>Model</code>; it names the
         *     element
         */
        public function ColladaModel(name:String, source:String, upAxis:Object = null, scaling:String = Model.FOOTPRINT)
        {
            super(name, ORIGIN);
            setShape(new ColladaReader(name, source, upAxis).readShape(scaling, upAxis as ModelTransform));
        }

        /**
         * Reads a model from a file's bytes: a document (UTF-8, UTF-16, ISO 8859-1 or Windows-1252) or a zipped one
         * (.zae).
         *
         * @param name what agents call the shape, not empty
         * @param bytes the whole file; its position is left anywhere
         * @param upAxis null for the axis that the document says; "x", "y", "z" or a ModelTransform in place of that
         * @param scaling as for <code>Model</code>
         * @throws ModelError as the constructor does, or if an archive is damaged or has no document in it
         */
        public static function fromBytes(name:String, bytes:ByteArray, upAxis:Object = null, scaling:String = Model.FOOTPRINT):ColladaModel
        {
            return new ColladaModel(name, ModelFile.colladaText(name, bytes), upAxis, scaling);
        }
    }
}
