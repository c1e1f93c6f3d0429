package starlogo.models.building
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.AffineTransform;
    import starlogo.geometry.cubeRoot;
    import starlogo.geometry.vertices.VertexBounds;
    import starlogo.geometry.vertices.triangleProblem;
    import starlogo.geometry.vertices.vertexProblem;
    import starlogo.models.Model;
    import starlogo.models.ModelMaker;
    import starlogo.models.ModelTransform;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The work that makes a model. The reader of a file's format fills the data with what the file says. Then these are checked, turned to z up,
     * and turned, scaled and moved as Model says. A step takes about a millisecond, and throws a ModelError if the file is wrong.
     *
     * @private
     */
    public final class ModelBuilder extends StepSequence implements ModelMaker
    {
        // Extents in x and y below this fraction of the z extent are rounding errors of the program that placed the vertices.
        private static const LINE_RATIO:Number = 1e-6;

        private static const VERTICES_PER_STEP:int = 4000;
        private static const CORNERS_PER_STEP:int = 20000;

        private var _data:ModelData;
        private var _model:Model = null;

        // the box around the vertices, as they are after the steps so far
        private var _bounds:VertexBounds;

        /**
         * @param data what the model is made of. The steps change it, and throw the errors of Model's constructor
         * @param reader fills the data first; none of its steps is done yet. Null if the data have been filled
         */
        public function ModelBuilder(data:ModelData, reader:FormatReader = null)
        {
            _data = data;
            add(reader || new StepSequence()).call(checkData).call(addParts);
        }

        /** The work that reads and makes a model. @param reader reads the file; none of its steps is done yet */
        public static function reading(reader:FormatReader):ModelBuilder
        {
            return new ModelBuilder(reader.data, reader);
        }

        /**
         * Builds the data of a model that is not read from a file.
         *
         * @param name the model's name
         * @param vertices x, y, z of each; copied
         * @param triangles three vertex indices each; copied; null for none
         * @param scaling as for Model's constructor
         * @param transform null for none
         * @throws ModelError as Model's constructor
         */
        public static function dataOf(name:String, vertices:Vector.<Number>, triangles:Vector.<uint>, scaling:String, transform:ModelTransform = null):ModelData
        {
            var data:ModelData = new ModelData(name);
            data.vertices = vertices == null ? data.vertices : vertices.slice();
            data.triangles = triangles == null ? data.triangles : triangles.slice();
            data.scaling = scaling;
            data.transform = transform;
            return new ModelBuilder(data).build();
        }

        /** Does all steps that are left. Returns the data, which are complete then. */
        public function build():ModelData
        {
            finish(this);
            return _data;
        }

        /** @inheritDoc */
        public function get name():String
        {
            return _data.name;
        }

        /** @inheritDoc Reading the file is nearly all of the work. */
        public function get progress():Number
        {
            return _data.readProgress;
        }

        /** The model, always the same one. Read it when no step is left. */
        public function get model():Model
        {
            return _model ||= new Model(name, null, null, null, _data);
        }

        private function checkData():void
        {
            var count:int = _data.vertices.length;
            refuseModelIf(_data.name == "", _data.name, "a model needs a name that is not empty");
            refuseModelIf(count == 0, _data.name, "no vertices: a model needs at least one");
            refuseModelIf(count % 3 != 0, _data.name, "vertices have three coordinates each, but there are " + count + " in all");
            ModelData.requireScaling(_data.name, _data.scaling);
        }

        private function addParts():void
        {
            begin(turningToZUp).begin(measuring);
            if (_data.isInModelSpace)
            {
                call(checkExtent);
            }
            else
            {
                addNormalising();
            }
            slices(_data.triangles.length, CORNERS_PER_STEP, checkCorners);
            if (_data.transform != null && _data.transform.isMirror)
            {
                add(reversingWinding(_data.triangles, 0));
            }
            call(close);
        }

        private function addNormalising():void
        {
            if (_data.scaling == Model.VOLUME)
            {
                begin(normalisingVolume).begin(rotating).begin(normalisingVolume);
            }
            else
            {
                begin(rotating);
            }
            begin(scalingByFactors).begin(_data.scaling == Model.FOOTPRINT ? placingFootprint : translating);
        }

        private function turningToZUp():Steps
        {
            return _data.upAxis == "z" ? null : AffineTransform.toZUp(_data.upAxis).transformingPoints(_data.vertices);
        }

        private function measuring():Steps
        {
            _bounds = new VertexBounds();
            return new StepSequence().slices(_data.vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    _bounds.add(_data.vertices, first, end);
                    var problem:String = _bounds.areFinite ? null : vertexProblem(_data.vertices);
                    refuseModelIf(problem != null, _data.name, problem);
                });
        }

        private function rotating():Steps
        {
            var transform:ModelTransform = _data.transform;
            return transform == null || transform.rotation.lengthSquared == 0 ? null : transforming(transform.rotationTransform(), 1);
        }

        private function scalingByFactors():Steps
        {
            var f:Vector3D = _data.transform == null ? new Vector3D(1, 1, 1) : _data.transform.scale;
            return f.x == 1 && f.y == 1 && f.z == 1 ? null : transforming(new AffineTransform(new <Number>[f.x, 0, 0, 0, 0, f.y, 0, 0, 0, 0, f.z, 0]),
                    cubeRoot(Math.abs(f.x)) * cubeRoot(Math.abs(f.y)) * cubeRoot(Math.abs(f.z)));
        }

        // The steps that turn or scale. The factor says how much larger this makes the model.
        private function transforming(transform:AffineTransform, factor:Number):Steps
        {
            _data.source.addTransform(transform, factor);
            return new StepSequence().add(transform.transformingPoints(_data.vertices)).begin(measuring);
        }

        // Puts the middle of the lowest face of the box at the origin, and makes the box as wide as the scaling FOOTPRINT says.
        private function placingFootprint():Steps
        {
            var unit:Number = Math.max(_bounds.extentX, _bounds.extentY);
            if (unit <= _bounds.extentZ * LINE_RATIO)
            {
                unit = _bounds.extentZ > 0 ? _bounds.extentZ : 1;
            }
            return placingBox(0, unit);
        }

        // Puts the middle of the box at the origin, and makes its volume 1.
        private function normalisingVolume():Steps
        {
            return placingBox(_bounds.extentZ / 2, cubeRootOrOne(_bounds.extentX) * cubeRootOrOne(_bounds.extentY) * cubeRootOrOne(_bounds.extentZ)).begin(measuring);
        }

        // The steps that put a point of the box at the origin, the middle in x and y, at a height above the floor; and divide by a divisor.
        private function placingBox(height:Number, divisor:Number):StepSequence
        {
            // 0 - 0 is 0, but -0 would be negative
            return placing(new Vector3D(_bounds.minX, _bounds.minY, _bounds.minZ), new Vector3D(0 - _bounds.extentX / 2, 0 - _bounds.extentY / 2, 0 - height), divisor);
        }

        // Moves by the transform. With the scaling VOLUME the lowest vertex is put at z = 0 first.
        private function translating():Steps
        {
            return placing(new Vector3D(0, 0, _data.scaling == Model.VOLUME ? _bounds.minZ : 0), _data.transform == null ? new Vector3D() : _data.transform.translation, 1).begin(measuring);
        }

        // The steps that put a low corner at the origin, move, and divide by a divisor. The differences from the corner come first and the division
        // last. So the bounds are exact, and the smallest and largest numbers work.
        private function placing(low:Vector3D, move:Vector3D, divisor:Number):StepSequence
        {
            checkExtent();
            _data.source.addMoveAndScale(low.x - move.x, low.y - move.y, low.z - move.z, divisor);
            var vertices:Vector.<Number> = _data.vertices;
            return new StepSequence().slices(vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = 3 * first; i < 3 * end; i += 3)
                    {
                        vertices[i] = (vertices[i] - low.x + move.x) / divisor;
                        vertices[int(i + 1)] = (vertices[int(i + 1)] - low.y + move.y) / divisor;
                        vertices[int(i + 2)] = (vertices[int(i + 2)] - low.z + move.z) / divisor;
                    }
                });
        }

        private function checkExtent():void
        {
            var size:Number = _bounds.extentX + _bounds.extentY + _bounds.extentZ;
            refuseModelIf(!(size < Infinity), _data.name, "the coordinates are too large: the model's extent is not a finite number");
        }

        private function checkCorners(first:int, end:int):void
        {
            var problem:String = triangleProblem(_data.triangles, _data.vertices.length / 3, first, end);
            refuseModelIf(problem != null, _data.name, problem);
        }

        private function close():void
        {
            _data.materials.seal(_data.triangles.length / 3);
            _data.meshes.seal(_data.triangles.length / 3);
            _data.vertices.fixed = _data.triangles.fixed = true;
            _data.triangles = _data.triangles.length == 0 ? null : _data.triangles;
        }

        // as in the client: an extent of 0 counts as 1
        private static function cubeRootOrOne(extent:Number):Number
        {
            return extent == 0 ? 1 : cubeRoot(extent);
        }
    }
}
