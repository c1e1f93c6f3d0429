package starlogo.models
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.VertexBounds;
    import starlogo.geometry.VertexData;
    import starlogo.geometry.cubeRoot;
    import starlogo.models.cooked.CookedFile;
    import starlogo.steps.Slices;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /** A shape for a model: checked, copied, turned and normalised as Model says, in steps. */
    internal final class NormalisedShape extends StepSequence
    {
        // Extents in x and y below this fraction of the z extent are rounding errors of the program that placed the vertices.
        private static const LINE_RATIO:Number = 1e-6;

        private static const VERTICES_PER_STEP:int = 4000;
        private static const CORNERS_PER_STEP:int = 20000;

        /** The model's name. */
        public var name:String;

        /** When no step is left: x, y, z, ... */
        public var vertices:Vector.<Number>;

        /** When no step is left: three indices for each triangle, or null. */
        public var triangles:Vector.<uint> = null;

        /** When no step is left: the shape's place and scale in its source. */
        public var frame:SourceFrame = new SourceFrame();

        /** The cooked file that the shape was read from; null for none. */
        public var cooked:CookedFile = null;

        /** The material and the mesh of each triangle; null if no triangle has one. A reader sets them. */
        public var materials:TriangleLabels = null;
        public var meshes:TriangleLabels = null;

        /** When no step is left: whether the order of the triangles was reversed. */
        public var isTurnedRound:Boolean = false;

        private var _bounds:VertexBounds;

        /**
         * @param name what agents call the shape
         * @param vertices x, y, z, ..., in any unit; is not changed
         * @param triangles three indices for each triangle, null or empty; is not changed
         * @param scaling as for Model's constructor
         * @param transform turns, scales and moves the shape; null for no change
         * @param unit the factor for Model.AS_GIVEN, which has an effect without a transform
         * @throws ModelError if there is no name or no vertex, if the scaling is unknown, or if the last vertex or triangle is incomplete.
         * The steps throw the other errors of Model's constructor
         */
        public function NormalisedShape(name:String, vertices:Vector.<Number>, triangles:Vector.<uint>, scaling:String,
                transform:ModelTransform = null, unit:Number = 1)
        {
            this.name = name || "";
            check(this.name == "" ? "a model needs a name that is not empty" : null);
            check(vertices == null || vertices.length == 0 ? "no vertices: a model needs at least one" : null);
            check(vertices.length % 3 == 0 ? null : VertexData.vertexProblem(vertices));
            this.vertices = vertices.slice();
            unit = scaling == Model.AS_GIVEN ? unit : 1;
            var factors:Vector3D = transform == null ? new Vector3D(unit, unit, unit) : transform.scale;
            frame.scaling = scaling;
            frame.transform = transform;
            measureAll();
            switch (scaling)
            {
                case Model.FOOTPRINT:
                    turnAll().scaleAll(factors).begin(placingFootprint);
                    break;
                case Model.VOLUME:
                    centreAll().turnAll().centreAll().scaleAll(factors).begin(translating);
                    break;
                case Model.AS_GIVEN:
                    turnAll().scaleAll(factors).begin(translating);
                    break;
                default:
                    check("the scaling must be Model.FOOTPRINT, VOLUME or AS_GIVEN, not \"" + scaling + "\"");
            }
            if (triangles != null && triangles.length > 0)
            {
                check(VertexData.triangleProblem(triangles, vertices.length / 3, 0, 0));
                this.triangles = triangles.slice();
                slices(triangles.length, CORNERS_PER_STEP, checkCorners);
                if (factors.x * factors.y * factors.z < 0)
                {
                    call(turnRound);
                }
            }
        }

        private function check(problem:String):void
        {
            if (problem != null)
            {
                throw new ModelError(name, "", problem);
            }
        }

        private function measureAll():NormalisedShape
        {
            slices(vertices.length / 3, VERTICES_PER_STEP, measure);
            return this;
        }

        private function centreAll():NormalisedShape
        {
            begin(placingVolume);
            return measureAll();
        }

        private function turnAll():NormalisedShape
        {
            var transform:ModelTransform = frame.transform;
            return transform == null || transform.rotation.lengthSquared == 0 ? this : turnBy(transform.rotationMatrix(), 1);
        }

        private function scaleAll(f:Vector3D):NormalisedShape
        {
            return f.x == 1 && f.y == 1 && f.z == 1 ? this : turnBy(new AffineTransform(new <Number>[f.x, 0, 0, 0, 0, f.y, 0, 0, 0, 0, f.z, 0]),
                    cubeRoot(Math.abs(f.x)) * cubeRoot(Math.abs(f.y)) * cubeRoot(Math.abs(f.z)));
        }

        // Turns or scales. The factor says how much larger this makes the model.
        private function turnBy(turn:AffineTransform, factor:Number):NormalisedShape
        {
            call(function():void
                {
                    frame.turn(turn, factor);
                }).add(turn.placing(vertices));
            return measureAll();
        }

        private function measure(first:int, end:int):void
        {
            _bounds = first == 0 ? new VertexBounds() : _bounds;
            _bounds.add(vertices, first, end);
            check(_bounds.areFinite ? null : VertexData.vertexProblem(vertices));
        }

        private function placingFootprint():Steps
        {
            var extentX:Number = _bounds.maxX - _bounds.minX;
            var extentY:Number = _bounds.maxY - _bounds.minY;
            var extentZ:Number = _bounds.maxZ - _bounds.minZ;
            var unit:Number = Math.max(extentX, extentY);
            if (unit <= extentZ * LINE_RATIO)
            {
                unit = extentZ > 0 ? extentZ : 1;
            }
            return placing(_bounds.minX, _bounds.minY, _bounds.minZ, extentX / 2, extentY / 2, 0, unit);
        }

        private function placingVolume():Steps
        {
            var extentX:Number = _bounds.maxX - _bounds.minX;
            var extentY:Number = _bounds.maxY - _bounds.minY;
            var extentZ:Number = _bounds.maxZ - _bounds.minZ;
            return placing(_bounds.minX, _bounds.minY, _bounds.minZ, extentX / 2, extentY / 2, extentZ / 2, rootOf(extentX) * rootOf(extentY) *
                    rootOf(extentZ));
        }

        // With Model.VOLUME the lowest vertex is put at z = 0.
        private function translating():Steps
        {
            var move:Vector3D = frame.transform == null ? new Vector3D() : frame.transform.translation;
            return placing(0, 0, frame.scaling == Model.VOLUME ? _bounds.minZ : 0, -move.x, -move.y, -move.z, 1);
        }

        // The steps that put the point that is a half above a low corner at the origin, and divide by a divisor.
        private function placing(lowX:Number, lowY:Number, lowZ:Number, halfX:Number, halfY:Number, halfZ:Number, divisor:Number):Steps
        {
            var size:Number = _bounds.maxX - _bounds.minX + _bounds.maxY - _bounds.minY + _bounds.maxZ - _bounds.minZ;
            check(size < Infinity ? null : "the coordinates are too large: the model's extent is not a finite number");
            frame.add(lowX + halfX, lowY + halfY, lowZ + halfZ, divisor);
            return new Slices(vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    // 0 - 0 is 0, but -0 would be negative
                    place(first, end, lowX, lowY, lowZ, 0 - halfX, 0 - halfY, 0 - halfZ, divisor);
                });
        }

        // The differences come first and the division last. So the bounds are exact, and the smallest and largest numbers work.
        private function place(first:int, end:int, lowX:Number, lowY:Number, lowZ:Number, moveX:Number, moveY:Number, moveZ:Number,
                divisor:Number):void
        {
            var placed:Vector.<Number> = vertices;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var j:int = i + 1;
                var k:int = i + 2;
                placed[i] = (placed[i] - lowX + moveX) / divisor;
                placed[j] = (placed[j] - lowY + moveY) / divisor;
                placed[k] = (placed[k] - lowZ + moveZ) / divisor;
            }
        }

        private function checkCorners(first:int, end:int):void
        {
            check(VertexData.triangleProblem(triangles, vertices.length / 3, first, end));
        }

        // A mirror image's triangles get the reverse corner order, so that they still face outwards. Their own order is reversed too.
        private function turnRound():void
        {
            triangles.reverse();
            isTurnedRound = true;
        }

        // as in the client: an extent of 0 counts as 1
        private static function rootOf(extent:Number):Number
        {
            return extent == 0 ? 1 : cubeRoot(extent);
        }
    }
}
