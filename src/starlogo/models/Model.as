package starlogo.models
{
    import starlogo.engine;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The shape of a kind of agents, as the collision engine sees it: a name, vertices and, where known, triangles.
     *
     * <p>The vertices are normalised (thesis §2.2): centred on the origin in x and y, the lowest at z = 0, and scaled
     * uniformly so that the larger of the x and y extents is 1. In z a model may be taller than that. A model without
     * extent in x and y (less than a millionth of its extent in z) is a vertical line: it is scaled to a z extent of
     * 1. A single point is only moved to the origin.</p>
     *
     * <p>A model never changes. Its coordinates are finite and its triangles name vertices that exist; triangles
     * without area are kept.</p>
     */
    public class Model
    {
        private static const ORIGIN:Vector.<Number> = new <Number>[0, 0, 0];

        /**
         * The model's origin in the coordinates of the source that the model was made of.
         *
         * @private
         */
        engine var sourceX:Number;

        /**
         * @copy #sourceX
         *
         * @private
         */
        engine var sourceY:Number;

        /**
         * @copy #sourceX
         *
         * @private
         */
        engine var sourceZ:Number;

        /**
         * The length of the model's unit, in units of the source.
         *
         * @private
         */
        engine var sourceUnit:Number;

        private var _name:String;
        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint> = null;

        /**
         * Copies and normalises a shape.
         *
         * @param name what agents call the shape, not empty
         * @param vertices x, y, z, x, y, z, ... of at least one vertex, z up, in any unit; left as it is
         * @param triangles three vertex indices (0 is the first vertex) each, or null where only vertices are known; an
         *     empty one is taken for null; left as it is
         * @throws ModelError if the name is empty, there is no vertex, a coordinate is missing, not finite or so large
         *     that the model's extent is not finite, or an index names no vertex
         */
        public function Model(name:String, vertices:Vector.<Number>, triangles:Vector.<uint> = null)
        {
            var shape:NormalisedShape = new NormalisedShape(name, vertices, triangles);
            finish(shape);
            setShape(shape);
        }

        /**
         * A model made of a shape of which all steps are done.
         *
         * @private
         */
        internal static function of(shape:NormalisedShape):Model
        {
            var model:Model = new Model(shape.name, ORIGIN);
            model.setShape(shape);
            return model;
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

        private function setShape(shape:NormalisedShape):void
        {
            _name = shape.name;
            _vertices = shape.vertices;
            _vertices.fixed = true;
            _triangles = shape.triangles;
            if (_triangles != null)
            {
                _triangles.fixed = true;
            }
            sourceX = shape.originX;
            sourceY = shape.originY;
            sourceZ = shape.originZ;
            sourceUnit = shape.unit;
        }
    }
}
