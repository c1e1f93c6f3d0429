package starlogo.models.collada
{
    import starlogo.models.AffineTransform;
    import starlogo.models.shortened;
    import starlogo.models.text.TextWords;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** A COLLADA skin: its joints' names and matrices, and their weights at each point. Its steps read them. All that place it share it. */
    internal final class ColladaSkin extends StepSequence
    {
        private static const POINTS_PER_STEP:int = 1000;
        private static const INFLUENCES_PER_STEP:int = 2000;
        private static const MATRIX:int = 16;

        // programs invert matrices in 32 bits and write few digits, so their last rows are rounded
        private static const TOLERANCE:Number = 1e-4;

        /** The skin's element. */
        public var element:ColladaElement;

        /** What takes the points to where the skin was bound. */
        public var shape:AffineTransform;

        /** When all is read: the names of the joints. */
        public var names:ColladaList = null;

        /** When all is read: what takes points from where the skin was bound into each joint. */
        public var inverses:Vector.<AffineTransform> = null;

        // The influences of all points. Those of a point begin at _starts, which has an end after the last point. Joint -1 does not move.
        private var _starts:Vector.<int> = new <int>[0];
        private var _joints:Vector.<int> = new Vector.<int>();
        private var _weights:Vector.<Number> = new Vector.<Number>();

        /** @param element the skin's element @throws ModelError if its bind shape matrix is wrong */
        public function ColladaSkin(element:ColladaElement)
        {
            this.element = element;
            var matrix:ColladaElement = element.child("bind_shape_matrix");
            shape = matrix == null ? new AffineTransform() : matrix.toTransform();
            call(function():void
                {
                    readJoints(element.requiredChild("joints"));
                }).begin(readingWeights);
        }

        /** The steps that move points by a palette of a ColladaSkeleton. */
        public function moving(points:Vector.<Number>, palette:Vector.<AffineTransform>):Steps
        {
            var count:int = _starts.length - 1;
            element.refuseIf(points.length != 3 * count, "it has weights for " + count + " points, but its geometry has " + points.length / 3);
            element.limits.countNumbers(2 * _joints.length, element);
            return new StepSequence().slices(count, POINTS_PER_STEP, function(first:int, end:int):void
                {
                    move(points, palette, first, end);
                });
        }

        // The weights of a point are divided by their sum. A point without weights moves with the first joint.
        private function move(points:Vector.<Number>, palette:Vector.<AffineTransform>, first:int, end:int):void
        {
            var moved:Vector.<Number> = new Vector.<Number>(3);
            for (var i:int = first; i < end; i++)
            {
                var sum:Number = 0;
                var x:Number = 0;
                var y:Number = 0;
                var z:Number = 0;
                for (var k:int = _starts[i]; k < _starts[i + 1]; k++)
                {
                    var weight:Number = _weights[k];
                    palette[_joints[k] + 1].transformPoints(points, i, i + 1, moved, 0);
                    sum += weight;
                    x += weight * moved[0];
                    y += weight * moved[1];
                    z += weight * moved[2];
                }
                if (sum == 0)
                {
                    palette[1].transformPoints(points, i, i + 1, points, i);
                }
                else
                {
                    points[3 * i] = x / sum;
                    points[3 * i + 1] = y / sum;
                    points[3 * i + 2] = z / sum;
                }
                var all:Number = points[3 * i] + points[3 * i + 1] + points[3 * i + 2];
                if (all - all != 0)
                {
                    throw element.error("it moves points too far: their coordinates are not finite numbers");
                }
            }
        }

        private function readJoints(joints:ColladaElement):void
        {
            names = ColladaList.of(joints, "JOINT", ColladaList.NAMES, element);
            var matrices:ColladaList = ColladaList.of(joints, "INV_BIND_MATRIX", ["float_array"], element);
            joints.refuseIf(names.words.length == 0 || matrices.count != names.words.length || matrices.width != MATRIX,
                    "expected at least one joint, and a matrix for each, but found " + names.words.length + " and " + matrices.count);
            inverses = new Vector.<AffineTransform>();
            for (var i:int = 0; i < names.words.length; i++)
            {
                inverses.push(ColladaTransform.matrix(matrices.array, matrices.numbers.slice(MATRIX * i, MATRIX * i + MATRIX), TOLERANCE));
            }
        }

        private function readingWeights():Steps
        {
            var weighted:ColladaElement = element.requiredChild("vertex_weights");
            var weights:ColladaList = ColladaList.of(weighted, "WEIGHT", ["float_array"], element);
            var stride:Number = 1;
            for each (var input:ColladaElement in weighted.childrenNamed("input"))
            {
                stride = Math.max(stride, input.integer("offset", 0) + 1);
            }
            weighted.refuseIf(weighted.child("input", "JOINT") == null, "expected an <input> with the semantic JOINT");
            var joint:Number = weighted.child("input", "JOINT").integer("offset", 0);
            var weight:Number = weighted.child("input", "WEIGHT").integer("offset", 0);
            var indices:Array = weighted.child("v") == null ? [] : weighted.child("v").countedWords();
            var influences:Number = indices.length / stride;
            return new StepSequence().add(readingCounts(weighted, influences)).slices(influences, INFLUENCES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        _joints.push(weighted.toWholeNumber(indices[i * stride + joint], -1, inverses.length - 1, "a joint's index"));
                        var index:int = weighted.toWholeNumber(indices[i * stride + weight], 0, weights.words.length - 1, "a weight's index");
                        _weights.push(weights.array.toNumber(weights.words[index]));
                    }
                });
        }

        // The steps that read how many influences each point has. There are as many as given.
        private function readingCounts(element:ColladaElement, influences:Number):Steps
        {
            var counts:Array = element.requiredChild("vcount").countedWords();
            var sum:Number = 0;
            element.checkCount(counts.length, "numbers in <vcount>");
            return new StepSequence().slices(counts.length, INFLUENCES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        sum += element.toWholeNumber(counts[i], 0, influences, "the number of a point's joints");
                        _starts.push(sum);
                    }
                }).call(function():void
                {
                    element.refuseIf(sum != influences, "its <vcount> adds up to " + sum + " joints, but <v> has " + influences);
                });
        }
    }
}
