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
     * The work that makes a model of data. If there is a file, its ModelReader comes first, and fills the data with what the file says. Then these
     * are checked, turned to z up, and turned, scaled and moved as Model says. A step takes about a millisecond, and throws a ModelError if the file is
     * wrong.
     *
     * @private
     */
    public final class ModelBuilder extends StepSequence implements ModelMaker
    {
        // Extents in x and y below this fraction of the z extent are rounding errors of the program that placed the vertices.
        private static const LINE_RATIO:Number = 1e-6;

        private static const VERTICES_PER_STEP:int = 4000;
        private static const CORNERS_PER_STEP:int = 20000;

        /** What the model is made of: complete when no step is left. The steps change it. Read only. */
        public var data:ModelData;

        private var _reader:ModelReader;
        private var _model:Model = null;

        // the box around the vertices, as they are after the steps so far
        private var _bounds:VertexBounds;

        /**
         * @param data what the model is made of
         * @param reader fills the data; null if they are complete
         */
        public function ModelBuilder(data:ModelData, reader:ModelReader = null)
        {
            this.data = data;
            _reader = reader;
            if (reader != null)
            {
                add(reader);
            }
            call(checkData).call(addParts);
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
            var given:ModelData = new ModelData(name);
            given.vertices = vertices == null ? given.vertices : vertices.slice();
            given.triangles = triangles == null ? given.triangles : triangles.slice();
            given.scaling = scaling;
            given.transform = transform;
            return new ModelBuilder(given).build();
        }

        /** Does all steps that are left. Returns the data, which are complete then. */
        public function build():ModelData
        {
            finish(this);
            return data;
        }

        /** @inheritDoc */
        public function get name():String
        {
            return data.name;
        }

        /** @inheritDoc Reading the file is nearly all of the work. */
        public function get progress():Number
        {
            return _reader == null ? 1 : _reader.progress;
        }

        /** The model, always the same one. Read it when no step is left. */
        public function get model():Model
        {
            return _model ||= new Model(name, null, null, null, data);
        }

        private function checkData():void
        {
            var count:int = data.vertices.length;
            refuseModelIf(data.name == "", data.name, "a model needs a name that is not empty");
            refuseModelIf(count == 0, data.name, "no vertices: a model needs at least one");
            refuseModelIf(count % 3 != 0, data.name, "vertices have three coordinates each, but there are " + count + " in all");
            ModelData.requireScaling(data.name, data.scaling);
        }

        private function addParts():void
        {
            begin(turningToZUp).begin(measuring);
            if (data.isInModelSpace)
            {
                call(checkExtent);
            }
            else
            {
                addNormalising();
            }
            slices(data.triangles.length, CORNERS_PER_STEP, checkCorners);
            if (data.transform != null && data.transform.isMirror)
            {
                add(reversingWinding(data.triangles, 0));
            }
            call(close);
        }

        private function addNormalising():void
        {
            if (data.scaling == Model.VOLUME)
            {
                begin(normalisingVolume).begin(rotating).begin(normalisingVolume);
            }
            else
            {
                begin(rotating);
            }
            begin(scalingByFactors).begin(data.scaling == Model.FOOTPRINT ? placingFootprint : translating);
        }

        private function turningToZUp():Steps
        {
            return data.upAxis == "z" ? null : AffineTransform.toZUp(data.upAxis).transformingPoints(data.vertices);
        }

        private function measuring():Steps
        {
            _bounds = new VertexBounds();
            return new StepSequence().slices(data.vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    _bounds.add(data.vertices, first, end);
                    var problem:String = _bounds.areFinite ? null : vertexProblem(data.vertices);
                    refuseModelIf(problem != null, data.name, problem);
                });
        }

        private function rotating():Steps
        {
            var transform:ModelTransform = data.transform;
            return transform == null || transform.rotation.lengthSquared == 0 ? null : transforming(transform.rotationTransform(), 1);
        }

        private function scalingByFactors():Steps
        {
            var f:Vector3D = data.transform == null ? new Vector3D(1, 1, 1) : data.transform.scale;
            return f.x == 1 && f.y == 1 && f.z == 1 ? null : transforming(new AffineTransform(new <Number>[f.x, 0, 0, 0, 0, f.y, 0, 0, 0, 0, f.z, 0]),
                    cubeRoot(Math.abs(f.x)) * cubeRoot(Math.abs(f.y)) * cubeRoot(Math.abs(f.z)));
        }

        // The steps that turn or scale. The factor says how much larger this makes the model.
        private function transforming(transform:AffineTransform, factor:Number):Steps
        {
            data.source.addTransform(transform, factor);
            return new StepSequence().add(transform.transformingPoints(data.vertices)).begin(measuring);
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
            return placing(new Vector3D(0, 0, data.scaling == Model.VOLUME ? _bounds.minZ : 0), data.transform == null ? new Vector3D() : data.transform.translation, 1).begin(measuring);
        }

        // The steps that put a low corner at the origin, move, and divide by a divisor. The differences from the corner come first and the division
        // last. So the bounds are exact, and the smallest and largest numbers work.
        private function placing(low:Vector3D, move:Vector3D, divisor:Number):StepSequence
        {
            checkExtent();
            data.source.addMoveAndScale(low.x - move.x, low.y - move.y, low.z - move.z, divisor);
            var vertices:Vector.<Number> = data.vertices;
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
            refuseModelIf(!(size < Infinity), data.name, "the coordinates are too large: the model's extent is not a finite number");
        }

        private function checkCorners(first:int, end:int):void
        {
            var problem:String = triangleProblem(data.triangles, data.vertices.length / 3, first, end);
            refuseModelIf(problem != null, data.name, problem);
        }

        private function close():void
        {
            data.materials.seal(data.triangles.length / 3);
            data.meshes.seal(data.triangles.length / 3);
            data.vertices.fixed = data.triangles.fixed = true;
            data.triangles = data.triangles.length == 0 ? null : data.triangles;
        }

        // as in the client: an extent of 0 counts as 1
        private static function cubeRootOrOne(extent:Number):Number
        {
            return extent == 0 ? 1 : cubeRoot(extent);
        }
    }
}
