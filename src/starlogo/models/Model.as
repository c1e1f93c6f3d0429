package starlogo.models
{
    import starlogo.engine;
    import starlogo.geometry.VertexData;
    import starlogo.models.cooked.CookedFile;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The shape of a kind of agents, as the collision engine sees it: a name, vertices and, where known, triangles.
     *
     * <p>The vertices are normalised: <code>FOOTPRINT</code>, <code>VOLUME</code> and <code>AS_GIVEN</code> say how. An agent is the model,
     * scaled by its size, turned about the model's origin and put in its place.</p>
     *
     * <p>A model never changes. Its coordinates are finite and its triangles name vertices that exist; triangles
     * without area are kept.</p>
     */
    public class Model
    {
        /** The vertices of a model that takes its shape from elsewhere. */
        internal static const ORIGIN:Vector.<Number> = new <Number>[0, 0, 0];

        /**
         * The scaling of the thesis (§2.2), and of every model unless told: centred on the origin in x and y, the lowest vertex at z = 0, and
         * the larger of the x and y extents 1. In z a model may be taller than that. A model without extent in x and y (less than a
         * millionth of its extent in z) is a vertical line: it is scaled to a z extent of 1. A single point is only moved to the origin. Of a
         * ModelTransform its rotation and uneven scale are seen.
         */
        public static const FOOTPRINT:String = "footprint";

        /**
         * The scaling of the StarLogo Nova client of 2017: centred, and divided by the cube root of its box's volume, a length of 0 counting
         * as 1; turned as a ModelTransform says, and the same again; multiplied by the transform's factors; its lowest vertex put at z = 0; and
         * moved as the transform says.
         */
        public static const VOLUME:String = "volume";

        /**
         * No scaling: for vertices that are in the agent's own unit and place already. A ModelTransform turns, scales and moves them.
         */
        public static const AS_GIVEN:String = "as given";

        /**
         * The scalings, in the order of their numbers in cooked files.
         *
         * @private
         */
        engine static const SCALINGS:Vector.<String> = new <String>[FOOTPRINT, VOLUME, AS_GIVEN];

        /**
         * The file that has what was computed for the model; null for none.
         *
         * @private
         */
        engine var cooked:CookedFile = null;

        private var _name:String;
        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint> = null;
        private var _source:SourceFrame;

        /**
         * Copies and normalises a shape.
         *
         * @param name what agents call the shape, not empty
         * @param vertices x, y, z, x, y, z, ... of at least one vertex, z up, in any unit; left as it is
         * @param triangles three vertex indices (0 is the first vertex) each, or null where only vertices are known; an
         *     empty one is taken for null; left as it is
         * @param scaling <code>FOOTPRINT</code>, <code>VOLUME</code> or <code>AS_GIVEN</code>
         * @throws ModelError if the name is empty, there is no vertex, a coordinate is missing, not finite or so large
         *     that the model's extent is not finite, an index names no vertex, or the scaling is none
         * @throws ArgumentError in JavaScript, if an index is no integer from 0 to 4294967295, which all are in a Vector
         */
        public function Model(name:String, vertices:Vector.<Number>, triangles:Vector.<uint> = null, scaling:String = FOOTPRINT)
        {
            var shape:NormalisedShape = new NormalisedShape(name, vertices, triangles, scaling);
            finish(shape);
            setShape(shape);
        }

        /** A model made of a shape of which all steps are done. */
        internal static function of(shape:NormalisedShape):Model
        {
            var model:Model = new Model(shape.name, ORIGIN);
            model.setShape(shape);
            return model;
        }

        /** Where the model is in what it was made of, and how large: for a renderer that draws the source. The model's own. */
        public function get source():SourceFrame
        {
            return _source;
        }

        /** What agents call the shape. */
        public function get name():String
        {
            return _name;
        }

        /** The vertices, normalised: x, y, z, x, y, z, ... The model's own: do not change them. */
        public function get vertices():Vector.<Number>
        {
            return _vertices;
        }

        /**
         * Three vertex indices per triangle, or null where only vertices are known. The model's own: do not change
         * them.
         */
        public function get triangles():Vector.<uint>
        {
            return _triangles;
        }

        /**
         * Whether points, turned and scaled as the model's were, are its vertices to the last bit, and in the same place of its source.
         *
         * @private
         */
        engine final function isMadeOf(points:Vector.<Number>):Boolean
        {
            var shape:NormalisedShape = new NormalisedShape(_name, points, _triangles, _source.scaling, _source.transform);
            finish(shape);
            return VertexData.areSame(shape.vertices, _vertices) && shape.frame.isAs(_source) && String(shape.triangles) == String(_triangles);
        }

        /** Gives the model its shape, all steps of which are done. */
        internal final function setShape(shape:NormalisedShape):void
        {
            _name = shape.name;
            _vertices = shape.vertices;
            _vertices.fixed = true;
            _triangles = shape.triangles;
            if (_triangles != null)
            {
                _triangles.fixed = true;
            }
            _source = shape.frame;
        }
    }
}
