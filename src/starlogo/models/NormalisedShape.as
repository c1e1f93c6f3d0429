package starlogo.models
{
    import starlogo.geometry.VertexBounds;
    import starlogo.geometry.VertexData;
    import starlogo.steps.StepSequence;

    /** What a model is made of: a shape checked, copied and normalised as Model says, in steps. */
    internal final class NormalisedShape extends StepSequence
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

        private var _bounds:VertexBounds = new VertexBounds();

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
            slices(count, VERTICES_PER_STEP, measure).call(findUnit).slices(count, VERTICES_PER_STEP, place);
            if (triangles != null && triangles.length > 0)
            {
                check(triangles.length % 3 == 0 ? null : VertexData.triangleProblem(triangles, count));
                this.triangles = triangles.slice();
                slices(triangles.length, CORNERS_PER_STEP, checkCorners);
            }
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
            _bounds.add(vertices, first, end);
            check(_bounds.areFinite ? null : VertexData.vertexProblem(vertices));
        }

        private function findUnit():void
        {
            var extentX:Number = _bounds.maxX - _bounds.minX;
            var extentY:Number = _bounds.maxY - _bounds.minY;
            var extentZ:Number = _bounds.maxZ - _bounds.minZ;
            check(extentX + extentY + extentZ < Infinity ? null
                    : "the coordinates are too large: the model's extent is not a finite number");
            originX = _bounds.minX + extentX / 2;
            originY = _bounds.minY + extentY / 2;
            originZ = _bounds.minZ;
            unit = Math.max(extentX, extentY);
            if (unit <= extentZ * LINE_RATIO)
            {
                unit = extentZ > 0 ? extentZ : 1;
            }
        }

        // Differences first, division last: that makes the bounds exact, and works for the smallest and largest
        // numbers.
        private function place(first:int, end:int):void
        {
            var placed:Vector.<Number> = vertices;
            var last:int = 3 * end;
            var minX:Number = _bounds.minX;
            var minY:Number = _bounds.minY;
            var minZ:Number = _bounds.minZ;
            var halfX:Number = (_bounds.maxX - minX) / 2;
            var halfY:Number = (_bounds.maxY - minY) / 2;
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
