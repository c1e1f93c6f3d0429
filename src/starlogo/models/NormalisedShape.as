package starlogo.models
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.VertexBounds;
    import starlogo.geometry.VertexData;
    import starlogo.geometry.cubeRoot;
    import starlogo.models.cooked.CookedFile;
    import starlogo.steps.StepSequence;

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

        private var _count:int;
        private var _transform:ModelTransform;
        private var _factors:Vector3D;
        private var _translation:Vector3D;
        private var _bounds:VertexBounds;

        // place() subtracts _low, adds _half and divides by _divisor
        private var _low:Vector3D = new Vector3D();
        private var _half:Vector3D = new Vector3D();
        private var _divisor:Number = 1;

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
            _count = vertices.length / 3;
            _transform = transform;
            unit = scaling == Model.AS_GIVEN ? unit : 1;
            _factors = transform == null ? new Vector3D(unit, unit, unit) : transform.scale;
            _translation = transform == null ? new Vector3D() : transform.translation;
            frame.scaling = scaling;
            frame.transform = transform;
            measureAll();
            switch (scaling)
            {
                case Model.FOOTPRINT:
                    turnAll().scaleAll().call(findFootprint).slices(_count, VERTICES_PER_STEP, place);
                    break;
                case Model.VOLUME:
                    centreAll().turnAll().centreAll().scaleAll().call(findTranslation).slices(_count, VERTICES_PER_STEP, place);
                    break;
                case Model.AS_GIVEN:
                    turnAll().scaleAll().call(findTranslation).slices(_count, VERTICES_PER_STEP, place);
                    break;
                default:
                    check("the scaling must be Model.FOOTPRINT, VOLUME or AS_GIVEN, not \"" + scaling + "\"");
            }
            if (triangles != null && triangles.length > 0)
            {
                check(VertexData.triangleProblem(triangles, _count, 0, 0));
                this.triangles = triangles.slice();
                slices(triangles.length, CORNERS_PER_STEP, checkCorners).call(turnRound);
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
            slices(_count, VERTICES_PER_STEP, measure);
            return this;
        }

        private function centreAll():NormalisedShape
        {
            call(findVolume).slices(_count, VERTICES_PER_STEP, place);
            return measureAll();
        }

        private function turnAll():NormalisedShape
        {
            return _transform == null || _transform.rotation.lengthSquared == 0 ? this : turnBy(_transform.rotationMatrix(), 1);
        }

        private function scaleAll():NormalisedShape
        {
            var f:Vector3D = _factors;
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

        private function findFootprint():void
        {
            var extentX:Number = _bounds.maxX - _bounds.minX;
            var extentY:Number = _bounds.maxY - _bounds.minY;
            var extentZ:Number = _bounds.maxZ - _bounds.minZ;
            var unit:Number = Math.max(extentX, extentY);
            if (unit <= extentZ * LINE_RATIO)
            {
                unit = extentZ > 0 ? extentZ : 1;
            }
            setPlace(_bounds.minX, _bounds.minY, _bounds.minZ, extentX / 2, extentY / 2, 0, unit);
        }

        private function findVolume():void
        {
            var extentX:Number = _bounds.maxX - _bounds.minX;
            var extentY:Number = _bounds.maxY - _bounds.minY;
            var extentZ:Number = _bounds.maxZ - _bounds.minZ;
            setPlace(_bounds.minX, _bounds.minY, _bounds.minZ, extentX / 2, extentY / 2, extentZ / 2, rootOf(extentX) * rootOf(extentY) *
                    rootOf(extentZ));
        }

        // With Model.VOLUME the lowest vertex is put at z = 0.
        private function findTranslation():void
        {
            setPlace(0, 0, frame.scaling == Model.VOLUME ? _bounds.minZ : 0, -_translation.x, -_translation.y, -_translation.z, 1);
        }

        private function setPlace(lowX:Number, lowY:Number, lowZ:Number, halfX:Number, halfY:Number, halfZ:Number, divisor:Number):void
        {
            var size:Number = _bounds.maxX - _bounds.minX + _bounds.maxY - _bounds.minY + _bounds.maxZ - _bounds.minZ;
            check(size < Infinity ? null : "the coordinates are too large: the model's extent is not a finite number");
            _low.setTo(lowX, lowY, lowZ);
            _half.setTo(0 - halfX, 0 - halfY, 0 - halfZ); // 0 - 0 is 0, but -0 would be negative
            _divisor = divisor;
            frame.place(lowX + halfX, lowY + halfY, lowZ + halfZ, divisor);
        }

        // The differences come first and the division last. So the bounds are exact, and the smallest and largest numbers work.
        private function place(first:int, end:int):void
        {
            var placed:Vector.<Number> = vertices;
            var last:int = 3 * end;
            var lowX:Number = _low.x;
            var lowY:Number = _low.y;
            var lowZ:Number = _low.z;
            var halfX:Number = _half.x;
            var halfY:Number = _half.y;
            var halfZ:Number = _half.z;
            var divisor:Number = _divisor;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var j:int = i + 1;
                var k:int = i + 2;
                placed[i] = (placed[i] - lowX + halfX) / divisor;
                placed[j] = (placed[j] - lowY + halfY) / divisor;
                placed[k] = (placed[k] - lowZ + halfZ) / divisor;
            }
        }

        private function checkCorners(first:int, end:int):void
        {
            check(VertexData.triangleProblem(triangles, _count, first, end));
        }

        // A mirror image's triangles get the reverse corner order, so that they still face outwards. Their own order is reversed too.
        private function turnRound():void
        {
            if (_factors.x * _factors.y * _factors.z < 0)
            {
                triangles.reverse();
            }
        }

        // as in the client: an extent of 0 counts as 1
        private static function rootOf(extent:Number):Number
        {
            return extent == 0 ? 1 : cubeRoot(extent);
        }
    }
}
