package starlogo.models.gltf
{
    import starlogo.models.AffineTransform;
    import starlogo.models.ModelError;
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;

    /**
     * Moves the points of a mesh with the joints of its skin at rest, in steps. The weights of a point are divided by their sum. A point
     * without weights moves with the first joint.
     */
    internal final class GltfSkin extends StepSequence
    {
        private static const POINTS_PER_STEP:int = 1000;
        private static const MAX_JOINTS:int = 50000;

        /** Whether the first joint mirrors. */
        public var isMirror:Boolean = false;

        private var _file:GltfFile;
        private var _scene:GltfScene;
        private var _skin:Object;
        private var _place:String;
        private var _points:Vector.<Number>;
        private var _joints:Vector.<AffineTransform> = new Vector.<AffineTransform>();
        private var _matrices:GltfAccessor;

        // pairs of accessors: the joints' indices, and their weights
        private var _sets:Vector.<GltfAccessor> = new Vector.<GltfAccessor>();

        /**
         * @param file the file
         * @param scene knows the joints' transforms
         * @param index the skin's index
         * @param attributes the primitive's attributes, with the joints and weights
         * @param place the primitive's place in the file, for errors
         * @param points x, y, z, ...; changed in place
         */
        public function GltfSkin(file:GltfFile, scene:GltfScene, index:int, attributes:Object, place:String, points:Vector.<Number>)
        {
            var json:GltfJson = file.json;
            _file = file;
            _scene = scene;
            _skin = json.entry("skins", index);
            _place = "skins[" + index + "]";
            _points = points;
            var count:int = points.length / 3;
            for (var i:int = 0; attributes["JOINTS_" + i] !== undefined; i++)
            {
                addSet(json.reference(attributes, "JOINTS_" + i, place, "accessors"), count);
                addSet(json.reference(attributes, "WEIGHTS_" + i, place, "accessors"), count);
            }
            var matrices:int = json.reference(_skin, "inverseBindMatrices", _place, "accessors");
            if (matrices >= 0)
            {
                _matrices = new GltfAccessor(file, matrices, "MAT4", MAX_JOINTS);
                add(_matrices);
            }
            call(findJoints).slices(count, POINTS_PER_STEP, move);
        }

        private function addSet(index:int, count:int):void
        {
            refuseIf(index < 0, _file.json.name, "a mesh has no weights for its joints", _place);
            var accessor:GltfAccessor = new GltfAccessor(_file, index, "VEC4", count);
            refuseIf(accessor.count < count, _file.json.name, "it has " + accessor.count + " elements, but there are " + count + " vertices", accessor.place);
            _sets.push(accessor);
            add(accessor);
        }

        private function findJoints():void
        {
            var json:GltfJson = _file.json;
            var list:Array = json.listIn(_skin, "joints", _place);
            refuseIf(list.length == 0 || list.length > MAX_JOINTS, json.name, "expected at least one joint, and at most " + MAX_JOINTS, _place + ".joints");
            refuseIf(_matrices != null && _matrices.count < list.length, json.name, "there are " + list.length +
                    " joints, but fewer matrices", _matrices == null ? "" : _matrices.place);
            for (var i:int = 0; i < list.length; i++)
            {
                var world:AffineTransform = _scene.worldOf(json.numberOf(list[i], _place + ".joints[" + i + "]", "nodes"));
                _joints.push(_matrices == null ? world : world.after(GltfScene.ofColumns(_matrices.numbers, 16 * i)));
            }
            isMirror = _joints[0].isMirror;
        }

        private function move(first:int, end:int):void
        {
            var moved:Vector.<Number> = new Vector.<Number>(3);
            for (var i:int = first; i < end; i++)
            {
                var at:int = 3 * i;
                var sum:Number = 0;
                var x:Number = 0;
                var y:Number = 0;
                var z:Number = 0;
                for (var k:int = 0; k < _sets.length; k += 2)
                {
                    for (var j:int = 4 * i; j < 4 * i + 4; j++)
                    {
                        var weight:Number = _sets[k + 1].numbers[j];
                        if (weight != 0)
                        {
                            jointAt(_sets[k], j).place(_points, i, i + 1, moved, 0);
                            sum += weight;
                            x += weight * moved[0];
                            y += weight * moved[1];
                            z += weight * moved[2];
                        }
                    }
                }
                if (sum == 0)
                {
                    _joints[0].place(_points, i, i + 1, moved, 0);
                    sum = 1;
                    x = moved[0];
                    y = moved[1];
                    z = moved[2];
                }
                _points[at] = x / sum;
                _points[int(at + 1)] = y / sum;
                _points[int(at + 2)] = z / sum;
            }
        }

        private function jointAt(numbers:GltfAccessor, at:int):AffineTransform
        {
            var joint:Number = numbers.numbers[at];
            if (!(joint >= 0 && joint < _joints.length && int(joint) == joint))
            {
                throw new ModelError(_file.json.name, numbers.place, "vertex " + (at >> 2) + " names joint " + joint + ", but there are only " + _joints.length);
            }
            return _joints[int(joint)];
        }
    }
}
