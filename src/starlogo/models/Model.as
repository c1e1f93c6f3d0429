package starlogo.models
{
    import starlogo.engine;
    import starlogo.geometry.VertexData;
    import starlogo.models.cooked.CookedFile;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * A shape that agents can have: a name, vertices and, if known, triangles.
     *
     * <p>The vertices are normalised: <code>FOOTPRINT</code>, <code>VOLUME</code> and <code>AS_GIVEN</code> say how. To place an agent, its
     * model is scaled by the agent's size, turned about the model's origin and moved to the agent's position.</p>
     *
     * <p>A model never changes. Its coordinates are finite, and its triangles use only existing vertices. Triangles without area are
     * kept.</p>
     */
    public class Model
    {
        /**
         * The default scaling, from the thesis (§2.2). The model is centred on the origin in x and y, its lowest vertex is at z = 0, and
         * the larger of its x and y extents is 1. Its height may be more than 1. If the x and y extents are both less than a millionth of
         * the z extent, the model is a vertical line and its z extent becomes 1. A single point is only moved to the origin. Only the
         * rotation and an uneven scale of a ModelTransform have an effect.
         */
        public static const FOOTPRINT:String = "footprint";

        /**
         * The scaling of the StarLogo Nova client of 2017. The model is centred, and divided by the cube root of its box's volume; a side
         * of length 0 counts as 1. Then it is turned by the ModelTransform, and centred and divided again. Then it is multiplied by the
         * transform's factors, its lowest vertex is put at z = 0, and the transform moves it.
         */
        public static const VOLUME:String = "volume";

        /**
         * No scaling, for vertices that are already in the agent's unit and place. A ModelTransform turns, scales and moves them. A COLLADA
         * document says how long its unit is: without a ModelTransform its vertices come in metres, a metre for a patch.
         */
        public static const AS_GIVEN:String = "as given";

        /**
         * The scalings. Cooked files store their index here.
         *
         * @private
         */
        engine static const SCALINGS:Vector.<String> = new <String>[FOOTPRINT, VOLUME, AS_GIVEN];

        /**
         * The cooked file with the results for the model; null for none.
         *
         * @private
         */
        engine var cooked:CookedFile;

        private var _name:String;
        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;
        private var _source:SourceFrame;

        /**
         * Copies and normalises a shape.
         *
         * @param name what agents call the shape, not empty
         * @param vertices x, y, z, x, y, z, ... of at least one vertex, z up, in any unit; is not changed
         * @param triangles three vertex indices for each triangle (0 is the first vertex); null or empty if only vertices are known; is not
         * changed
         * @param scaling <code>FOOTPRINT</code>, <code>VOLUME</code> or <code>AS_GIVEN</code>
         * @param shape for the engine alone: the shape that a reader has made. The other arguments are not used then
         * @throws ModelError if the name is empty, if there is no vertex, if a coordinate is missing, not finite or so large that the
         * model's extent is not finite, if an index names no vertex, or if the scaling is unknown
         * @throws ArgumentError in JavaScript, if an index is no integer from 0 to 4294967295. In a Vector all indices are such integers
         */
        public function Model(name:String, vertices:Vector.<Number>, triangles:Vector.<uint> = null, scaling:String = FOOTPRINT, shape:Steps = null)
        {
            var made:NormalisedShape = shape as NormalisedShape;
            if (made == null)
            {
                made = new NormalisedShape(name, vertices, triangles, scaling);
                finish(made);
            }
            _name = made.name;
            _vertices = made.vertices;
            _vertices.fixed = true;
            _triangles = made.triangles;
            if (_triangles != null)
            {
                _triangles.fixed = true;
            }
            _source = made.frame;
            cooked = made.cooked;
        }

        /** The model's place and scale in its source, for a renderer that draws the source. Shared with the model. */
        public function get source():SourceFrame
        {
            return _source;
        }

        /** The name by which agents select the shape. */
        public function get name():String
        {
            return _name;
        }

        /** The normalised vertices: x, y, z, x, y, z, ... This is the model's own vector: do not change it. */
        public function get vertices():Vector.<Number>
        {
            return _vertices;
        }

        /** Three vertex indices per triangle, or null if only vertices are known. This is the model's own vector: do not change it. */
        public function get triangles():Vector.<uint>
        {
            return _triangles;
        }

        /**
         * Whether the points make this model. They are normalised in the same way. Then they must equal its vertices to the last bit, and
         * their frame must equal its source frame.
         *
         * @private
         */
        engine final function isMadeOf(points:Vector.<Number>):Boolean
        {
            var shape:NormalisedShape = new NormalisedShape(_name, points, _triangles, _source.scaling, _source.transform);
            finish(shape);
            return VertexData.areSame(shape.vertices, _vertices) && shape.frame.isAs(_source) && String(shape.triangles) == String(_triangles);
        }
    }
}
