package starlogo.models
{
    import starlogo.engine;
    import starlogo.geometry.VertexData;

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
        // below this ratio to z, extents in x and y are rounding errors of whatever placed the vertices
        private static const LINE_RATIO:Number = 1e-6;

        /**
         * Where the model's origin was in what the model was made of.
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
         * How many units of what the model was made of one of the model's is.
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
            _name = name;
            checkName();
            checkVertices(vertices);
            _vertices = vertices.slice();
            normalise();
            _vertices.fixed = true;
            if (triangles != null && triangles.length > 0)
            {
                check(VertexData.triangleProblem(triangles, _vertices.length / 3));
                _triangles = triangles.slice();
                _triangles.fixed = true;
            }
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

        private function checkName():void
        {
            if (_name == null || _name == "")
            {
                throw new ModelError(_name || "", "", "a model needs a name, one that is not empty");
            }
        }

        private function checkVertices(vertices:Vector.<Number>):void
        {
            if (vertices == null || vertices.length == 0)
            {
                throw new ModelError(_name, "", "no vertices: a model needs at least one");
            }
            check(VertexData.vertexProblem(vertices));
        }

        private function check(problem:String):void
        {
            if (problem != null)
            {
                throw new ModelError(_name, "", problem);
            }
        }

        private function normalise():void
        {
            var minX:Number = Number.POSITIVE_INFINITY;
            var minY:Number = Number.POSITIVE_INFINITY;
            var minZ:Number = Number.POSITIVE_INFINITY;
            var maxX:Number = Number.NEGATIVE_INFINITY;
            var maxY:Number = Number.NEGATIVE_INFINITY;
            var maxZ:Number = Number.NEGATIVE_INFINITY;
            var length:int = _vertices.length;
            for (var i:int = 0; i < length; i += 3)
            {
                var x:Number = _vertices[i];
                var y:Number = _vertices[int(i + 1)];
                var z:Number = _vertices[int(i + 2)];
                if (x < minX)
                {
                    minX = x;
                }
                if (x > maxX)
                {
                    maxX = x;
                }
                if (y < minY)
                {
                    minY = y;
                }
                if (y > maxY)
                {
                    maxY = y;
                }
                if (z < minZ)
                {
                    minZ = z;
                }
                if (z > maxZ)
                {
                    maxZ = z;
                }
            }
            sourceUnit = scaleOf(maxX - minX, maxY - minY, maxZ - minZ);
            sourceX = minX + (maxX - minX) / 2;
            sourceY = minY + (maxY - minY) / 2;
            sourceZ = minZ;
            moveAndDivide(minX, minY, minZ, (maxX - minX) / 2, (maxY - minY) / 2, sourceUnit);
        }

        /** What coordinates are divided by. */
        private function scaleOf(extentX:Number, extentY:Number, extentZ:Number):Number
        {
            if (extentX + extentY + extentZ == Number.POSITIVE_INFINITY)
            {
                throw new ModelError(_name, "",
                        "the coordinates are too large: the model's extent is not a finite number");
            }
            var width:Number = Math.max(extentX, extentY);
            if (width <= extentZ * LINE_RATIO)
            {
                return extentZ > 0 ? extentZ : 1;
            }
            return width;
        }

        // Differences first, division last: that makes the bounds exact, and works for the smallest and largest
        // numbers.
        private function moveAndDivide(minX:Number, minY:Number, minZ:Number, halfX:Number, halfY:Number,
                divisor:Number):void
        {
            var length:int = _vertices.length;
            for (var i:int = 0; i < length; i += 3)
            {
                var j:int = i + 1;
                var k:int = i + 2;
                _vertices[i] = (_vertices[i] - minX - halfX) / divisor;
                _vertices[j] = (_vertices[j] - minY - halfY) / divisor;
                _vertices[k] = (_vertices[k] - minZ) / divisor;
            }
        }
    }
}
