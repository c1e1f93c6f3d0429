package starlogo.models.gltf
{
    import starlogo.models.AffineTransform;
    import starlogo.models.ModelBudget;
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

        private var _json:GltfJson;
        private var _points:GltfPoints;
        private var _joints:GltfJoints;

        // pairs of accessors: the joints' indices, and their weights
        private var _sets:Vector.<GltfAccessor> = new Vector.<GltfAccessor>();

        /**
         * @param file the file
         * @param joints the skin's joints; their steps may still be running
         * @param attributes the primitive's attributes, with the joints and weights
         * @param place their place in the file, for errors
         * @param points its numbers are changed
         */
        public function GltfSkin(file:GltfFile, joints:GltfJoints, attributes:Object, place:String, points:GltfPoints)
        {
            _json = file.json;
            _joints = joints;
            _points = points;
            add(joints);
            var count:int = points.count;
            for (var i:int = 0; attributes["JOINTS_" + i] !== undefined; i++)
            {
                for each (var key:String in ["JOINTS_" + i, "WEIGHTS_" + i])
                {
                    var index:int = _json.reference(attributes, key, place, "accessors");
                    refuseIf(index < 0, _json.name, "a mesh has no weights for its joints", place);
                    var accessor:GltfAccessor = file.accessor(index, "VEC4");
                    refuseIf(accessor.count != count, _json.name, "it has " + accessor.count + " elements, but there are " + count + " vertices", accessor.place);
                    _sets.push(accessor);
                    add(accessor);
                }
            }
            file.budget.take(ModelBudget.NUMBERS, 2 * count * Number(_sets.length), place);
            slices(count, POINTS_PER_STEP, move);
        }

        /** Whether the first joint mirrors. Read it when no step is left. */
        public function get isMirror():Boolean
        {
            return _joints.transforms[0].isMirror;
        }

        private function move(first:int, end:int):void
        {
            var points:Vector.<Number> = _points.numbers;
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
                            jointAt(_sets[k], j).place(points, i, i + 1, moved, 0);
                            sum += weight;
                            x += weight * moved[0];
                            y += weight * moved[1];
                            z += weight * moved[2];
                        }
                    }
                }
                if (sum == 0)
                {
                    _joints.transforms[0].place(points, i, i + 1, moved, 0);
                    sum = 1;
                    x = moved[0];
                    y = moved[1];
                    z = moved[2];
                }
                points[at] = x / sum;
                points[int(at + 1)] = y / sum;
                points[int(at + 2)] = z / sum;
            }
        }

        private function jointAt(numbers:GltfAccessor, at:int):AffineTransform
        {
            var joint:Number = numbers.numbers[at];
            if (!(joint >= 0 && joint < _joints.transforms.length && int(joint) == joint))
            {
                throw new ModelError(_json.name, numbers.place, "vertex " + (at >> 2) + " names joint " + joint + ", but there are only " + _joints.transforms.length);
            }
            return _joints.transforms[int(joint)];
        }
    }
}
