package starlogo.models
{
    import starlogo.geometry.VertexData;
    import starlogo.steps.Slices;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** What a model is made of: a shape checked, copied and normalised as Model says, in steps. */
    internal final class NormalisedShape implements Steps
    {
        // below this ratio to z, extents in x and y are rounding errors of whatever placed the vertices
        private static const LINE_RATIO:Number = 1e-6;

        private static const VERTICES_PER_STEP:int = 4000;
        private static const CORNERS_PER_STEP:int = 20000;

        /** What the model is called. */
        public var name:String;

        /** When no step is left: x, y, z, ... */
        public var vertices:Vector.<Number>;

        /** When no step is left: three indices each, or null. */
        public var triangles:Vector.<uint> = null;

        /** Where the origin was, when no step is left. */
        public var originX:Number;

        /** @copy #originX */
        public var originY:Number;

        /** @copy #originX */
        public var originZ:Number;

        /** How long the unit was, when no step is left. */
        public var unit:Number;

        private var _minX:Number = Infinity;
        private var _minY:Number = Infinity;
        private var _minZ:Number = Infinity;
        private var _maxX:Number = -Infinity;
        private var _maxY:Number = -Infinity;
        private var _maxZ:Number = -Infinity;
        private var _work:StepSequence = new StepSequence();

        /**
         * @param name what agents call the shape
         * @param vertices x, y, z, ..., in any unit; left as it is
         * @param triangles three indices each, null or empty; left as it is
         * @throws ModelError if there is no name or no vertex, or a number is missing; what else Model's constructor throws, the steps do
         */
        public function NormalisedShape(name:String, vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            this.name = name || "";
            check(this.name == "" ? "a model needs a name, one that is not empty" : null);
            check(vertices == null || vertices.length == 0 ? "no vertices: a model needs at least one" : null);
            check(vertices.length % 3 == 0 ? null : VertexData.vertexProblem(vertices));
            this.vertices = vertices.slice();
            var count:int = vertices.length / 3;
            _work.add(new Slices(count, VERTICES_PER_STEP, measure)).call(findUnit).add(new Slices(count, VERTICES_PER_STEP, place));
            if (triangles != null && triangles.length > 0)
            {
                check(triangles.length % 3 == 0 ? null : VertexData.triangleProblem(triangles, count));
                this.triangles = triangles.slice();
                _work.add(new Slices(triangles.length, CORNERS_PER_STEP, checkCorners));
            }
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            return _work.step();
        }

        private function check(problem:String):void
        {
            if (problem != null)
            {
                throw new ModelError(name, "", problem);
            }
        }

        private function measure(first:int, end:int):void
        {
            var shape:Vector.<Number> = vertices;
            var last:int = 3 * end;
            var differences:Number = 0;
            var minX:Number = _minX;
            var minY:Number = _minY;
            var minZ:Number = _minZ;
            var maxX:Number = _maxX;
            var maxY:Number = _maxY;
            var maxZ:Number = _maxZ;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var x:Number = shape[i];
                var y:Number = shape[int(i + 1)];
                var z:Number = shape[int(i + 2)];
                // infinity minus itself is NaN
                differences += x - x + y - y + z - z;
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
            _minX = minX;
            _minY = minY;
            _minZ = minZ;
            _maxX = maxX;
            _maxY = maxY;
            _maxZ = maxZ;
            check(differences == 0 ? null : VertexData.vertexProblem(vertices));
        }

        private function findUnit():void
        {
            unit = unitOf(_maxX - _minX, _maxY - _minY, _maxZ - _minZ);
            originX = _minX + (_maxX - _minX) / 2;
            originY = _minY + (_maxY - _minY) / 2;
            originZ = _minZ;
        }

        private function unitOf(extentX:Number, extentY:Number, extentZ:Number):Number
        {
            check(extentX + extentY + extentZ < Infinity ? null
                    : "the coordinates are too large: the model's extent is not a finite number");
            var width:Number = Math.max(extentX, extentY);
            if (width <= extentZ * LINE_RATIO)
            {
                return extentZ > 0 ? extentZ : 1;
            }
            return width;
        }

        // Differences first, division last: that makes the bounds exact, and works for the smallest and largest
        // numbers.
        private function place(first:int, end:int):void
        {
            var placed:Vector.<Number> = vertices;
            var last:int = 3 * end;
            var minX:Number = _minX;
            var minY:Number = _minY;
            var minZ:Number = _minZ;
            var halfX:Number = (_maxX - minX) / 2;
            var halfY:Number = (_maxY - minY) / 2;
            var divisor:Number = unit;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var j:int = i + 1;
                var k:int = i + 2;
                placed[i] = (placed[i] - minX - halfX) / divisor;
                placed[j] = (placed[j] - minY - halfY) / divisor;
                placed[k] = (placed[k] - minZ) / divisor;
            }
        }

        private function checkCorners(first:int, end:int):void
        {
            var count:uint = vertices.length / 3;
            var corners:Vector.<uint> = triangles;
            for (var i:int = first; i < end; i++)
            {
                if (corners[i] >= count)
                {
                    check(VertexData.triangleProblem(corners, count));
                }
            }
        }
    }
}
