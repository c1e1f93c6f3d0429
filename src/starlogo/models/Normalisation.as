package starlogo.models
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.AffineTransform;
    import starlogo.geometry.VertexBounds;
    import starlogo.geometry.VertexData;
    import starlogo.geometry.cubeRoot;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /** Checks what a model is made of, and turns, scales and moves it as Model says, in steps. */
    internal final class Normalisation extends StepSequence
    {
        // Extents in x and y below this fraction of the z extent are rounding errors of the program that placed the vertices.
        private static const LINE_RATIO:Number = 1e-6;

        private static const VERTICES_PER_STEP:int = 4000;
        private static const CORNERS_PER_STEP:int = 20000;

        private var _data:ModelData;
        private var _frame:SourceFrame = new SourceFrame();
        private var _bounds:VertexBounds;

        /**
         * @param data its vertices and triangles are complete, in any unit. The constructor changes what needs no steps, the steps the rest
         * @throws ModelError if there is no name or no vertex, if the scaling is unknown, or if the last vertex or triangle is incomplete.
         * The steps throw the other errors of Model's constructor
         */
        public function Normalisation(data:ModelData)
        {
            _data = data;
            var vertices:Vector.<Number> = data.vertices;
            refuseIf(data.name == "", data.name, "a model needs a name that is not empty");
            refuseIf(vertices.length == 0, data.name, "no vertices: a model needs at least one");
            refuseIf(vertices.length % 3 != 0, data.name, "vertices have three coordinates each, but there are " + vertices.length + " in all");
            vertices.fixed = true;
            refuseIf(Model.SCALINGS.indexOf(data.scaling) < 0, data.name, "the scaling must be Model.FOOTPRINT, VOLUME or AS_GIVEN, not \"" + data.scaling + "\"");
            var unit:Number = data.scaling == Model.AS_GIVEN ? data.unit : 1;
            var factors:Vector3D = data.transform == null ? new Vector3D(unit, unit, unit) : data.transform.scale;
            addMeasuring();
            // data that have a frame are normalised already
            if (data.frame != null)
            {
                call(checkExtent);
            }
            else
            {
                data.frame = _frame;
                addPlacing(factors);
            }
            var triangleCount:int = data.triangles.length / 3;
            data.materials = data.materials.trim(triangleCount);
            data.meshes = data.meshes.trim(triangleCount);
            checkCorners(0, 0);
            data.triangles = triangleCount == 0 ? null : data.triangles;
            if (triangleCount > 0)
            {
                data.triangles.fixed = true;
                slices(3 * triangleCount, CORNERS_PER_STEP, checkCorners);
                if (factors.x * factors.y * factors.z < 0)
                {
                    call(reverseTriangles);
                }
            }
        }

        private function addPlacing(factors:Vector3D):void
        {
            switch (_data.scaling)
            {
                case Model.FOOTPRINT:
                    addTurning().addScaling(factors).begin(placingFootprint);
                    break;
                case Model.VOLUME:
                    addCentring().addTurning().addCentring().addScaling(factors).begin(translating);
                    break;
                default:
                    addTurning().addScaling(factors).begin(translating);
            }
        }

        private function addMeasuring():Normalisation
        {
            slices(_data.vertices.length / 3, VERTICES_PER_STEP, measure);
            return this;
        }

        private function addCentring():Normalisation
        {
            begin(placingVolume);
            return addMeasuring();
        }

        private function addTurning():Normalisation
        {
            var transform:ModelTransform = _data.transform;
            return transform == null || transform.rotation.lengthSquared == 0 ? this : addTransforming(transform.rotationTransform(), 1);
        }

        private function addScaling(f:Vector3D):Normalisation
        {
            return f.x == 1 && f.y == 1 && f.z == 1 ? this : addTransforming(new AffineTransform(new <Number>[f.x, 0, 0, 0, 0, f.y, 0, 0, 0, 0, f.z, 0]),
                    cubeRoot(Math.abs(f.x)) * cubeRoot(Math.abs(f.y)) * cubeRoot(Math.abs(f.z)));
        }

        // Adds steps that turn or scale. The factor says how much larger this makes the model.
        private function addTransforming(transform:AffineTransform, factor:Number):Normalisation
        {
            call(function():void
                {
                    _frame.addTransform(transform, factor);
                }).add(transform.transformingPoints(_data.vertices));
            return addMeasuring();
        }

        private function measure(first:int, end:int):void
        {
            _bounds = first == 0 ? new VertexBounds() : _bounds;
            _bounds.add(_data.vertices, first, end);
            if (!_bounds.areFinite)
            {
                throw new ModelError(_data.name, "", VertexData.vertexProblem(_data.vertices));
            }
        }

        private function placingFootprint():Steps
        {
            var unit:Number = Math.max(_bounds.extentX, _bounds.extentY);
            if (unit <= _bounds.extentZ * LINE_RATIO)
            {
                unit = _bounds.extentZ > 0 ? _bounds.extentZ : 1;
            }
            return placingBox(0, unit);
        }

        private function placingVolume():Steps
        {
            return placingBox(_bounds.extentZ / 2, rootOf(_bounds.extentX) * rootOf(_bounds.extentY) * rootOf(_bounds.extentZ));
        }

        // The steps that put a point of the box at the origin, the middle in x and y, at a height above the floor; and divide by a divisor.
        private function placingBox(height:Number, divisor:Number):Steps
        {
            return placing(_bounds.minX, _bounds.minY, _bounds.minZ, _bounds.extentX / 2, _bounds.extentY / 2, height, divisor);
        }

        // Moves by the transform. With the scaling VOLUME the lowest vertex is put at z = 0 first.
        private function translating():Steps
        {
            var move:Vector3D = _data.transform == null ? new Vector3D() : _data.transform.translation;
            return placing(0, 0, _data.scaling == Model.VOLUME ? _bounds.minZ : 0, -move.x, -move.y, -move.z, 1);
        }

        // The steps that put a point at the origin, and divide by a divisor. The point is the sum of two, whose differences are exact.
        private function placing(firstX:Number, firstY:Number, firstZ:Number, secondX:Number, secondY:Number, secondZ:Number, divisor:Number):Steps
        {
            checkExtent();
            _frame.addMove(firstX + secondX, firstY + secondY, firstZ + secondZ, divisor);
            return new StepSequence().slices(_data.vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    // 0 - 0 is 0, but -0 would be negative
                    place(first, end, firstX, firstY, firstZ, 0 - secondX, 0 - secondY, 0 - secondZ, divisor);
                });
        }

        // The differences come first and the division last. So the bounds are exact, and the smallest and largest numbers work.
        private function place(first:int, end:int, firstX:Number, firstY:Number, firstZ:Number, moveX:Number, moveY:Number, moveZ:Number,
                divisor:Number):void
        {
            var placed:Vector.<Number> = _data.vertices;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var j:int = i + 1;
                var k:int = i + 2;
                placed[i] = (placed[i] - firstX + moveX) / divisor;
                placed[j] = (placed[j] - firstY + moveY) / divisor;
                placed[k] = (placed[k] - firstZ + moveZ) / divisor;
            }
        }

        private function checkExtent():void
        {
            var size:Number = _bounds.extentX + _bounds.extentY + _bounds.extentZ;
            refuseIf(!(size < Infinity), _data.name, "the coordinates are too large: the model's extent is not a finite number");
        }

        private function checkCorners(first:int, end:int):void
        {
            var problem:String = VertexData.triangleProblem(_data.triangles, _data.vertices.length / 3, first, end);
            refuseIf(problem != null, _data.name, problem);
        }

        // A mirror image's triangles get the reverse corner order, so that they still face outwards. Their own order is reversed too.
        private function reverseTriangles():void
        {
            _data.triangles.reverse();
            for each (var labels:TriangleLabels in [_data.materials, _data.meshes])
            {
                if (labels != null)
                {
                    labels.reverse(_data.triangles.length / 3);
                }
            }
        }

        // as in the client: an extent of 0 counts as 1
        private static function rootOf(extent:Number):Number
        {
            return extent == 0 ? 1 : cubeRoot(extent);
        }
    }
}
