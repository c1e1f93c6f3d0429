package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.animation.JointInfluences;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** A COLLADA skin: its joints' names and matrices, and their weights at each point. Its steps read them. All that place it share it. */
    internal final class ColladaSkin extends StepSequence
    {
        private static const POINTS_PER_STEP:int = 1000;
        private static const INFLUENCES_PER_STEP:int = 2000;

        // How far a number in the last row of an inverse matrix may be from 0 or 1. Programs invert matrices in 32 bits and write few digits.
        private static const LAST_ROW_TOLERANCE:Number = 1e-4;

        /** The skin's element. */
        public var element:ColladaElement;

        /** What takes the points to where the skin was bound. */
        public var shape:AffineTransform;

        /** When all is read: the names of the joints. */
        public var names:ColladaAccessor = null;

        /** When all is read: what takes points from where the skin was bound into each joint. */
        public var inverses:Vector.<AffineTransform> = null;

        // joint -1, which does not move, has the index after the last joint
        private var _influences:JointInfluences;

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
            var count:int = _influences.starts.length - 1;
            element.refuseIf(points.length != 3 * count, "it has weights for " + count + " points, but its geometry has " + points.length / 3);
            element.limits.countNumbers(2 * _influences.joints.length, element);
            return new StepSequence().slices(count, POINTS_PER_STEP, function(first:int, end:int):void
                {
                    element.refuseIf(!_influences.move(points, palette, first, end), "it moves points too far: their coordinates are not finite numbers");
                });
        }

        private function readJoints(joints:ColladaElement):void
        {
            names = ColladaAccessor.read(joints, "JOINT", ColladaAccessor.NAMES, element);
            var matrices:ColladaAccessor = ColladaAccessor.read(joints, "INV_BIND_MATRIX", ["float_array"], element);
            joints.refuseIf(names.words.length == 0 || matrices.count != names.words.length || matrices.width != ColladaTransform.MATRIX_SIZE,
                    "expected at least one joint, and a matrix for each, but found " + names.words.length + " and " + matrices.count);
            inverses = new Vector.<AffineTransform>();
            for (var i:int = 0; i < names.words.length; i++)
            {
                inverses.push(ColladaTransform.matrix(matrices.array, matrices.numbersOfEntry(i), LAST_ROW_TOLERANCE));
            }
        }

        private function readingWeights():Steps
        {
            var weighted:ColladaElement = element.requiredChild("vertex_weights");
            var weights:ColladaAccessor = ColladaAccessor.read(weighted, "WEIGHT", ["float_array"], element);
            var stride:Number = 1;
            for each (var input:ColladaElement in weighted.childrenNamed("input"))
            {
                stride = Math.max(stride, input.integer("offset", 0) + 1);
            }
            var jointOffset:Number = weighted.requiredInput("JOINT").integer("offset", 0);
            var weightOffset:Number = weighted.child("input", "WEIGHT").integer("offset", 0);
            var indices:Array = weighted.child("v") == null ? [] : weighted.child("v").countedWords();
            weighted.refuseIf(indices.length % stride != 0, "expected " + stride + " indices for each joint of a point, but found " + indices.length + " in all");
            var influenceCount:int = indices.length / stride;
            _influences = new JointInfluences(influenceCount);
            return new StepSequence().add(readingCounts(weighted, influenceCount)).slices(influenceCount, INFLUENCES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        var joint:int = weighted.toWholeNumber(indices[i * stride + jointOffset], -1, inverses.length - 1, "a joint's index");
                        var weight:int = weighted.toWholeNumber(indices[i * stride + weightOffset], 0, weights.words.length - 1, "a weight's index");
                        _influences.joints[i] = joint < 0 ? inverses.length : joint;
                        _influences.weights[i] = weights.array.toNumber(weights.words[weight]);
                    }
                });
        }

        // The steps that read how many influences each point has.
        private function readingCounts(element:ColladaElement, influenceCount:int):Steps
        {
            var counts:Array = element.requiredChild("vcount").countedWords();
            var sum:Number = 0;
            element.checkCount(counts.length, "numbers in <vcount>");
            return new StepSequence().slices(counts.length, INFLUENCES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        sum += element.toWholeNumber(counts[i], 0, influenceCount, "the number of a point's joints");
                        _influences.starts.push(sum);
                    }
                }).call(function():void
                {
                    element.refuseIf(sum != influenceCount, "its <vcount> adds up to " + sum + " joints, but <v> has " + influenceCount);
                });
        }
    }
}
