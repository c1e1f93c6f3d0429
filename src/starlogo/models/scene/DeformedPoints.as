package starlogo.models.scene
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * The points of an instance of a mesh, as morphs and skins move them.
     *
     * @private
     */
    public final class DeformedPoints
    {
        private static const POINTS_PER_STEP:int = 3000;
        private static const SKINNED_PER_STEP:int = 1000;

        /** x, y, z of each point. Read only. */
        public var points:Vector.<Number>;

        /** Takes the points to the scene. Read only. */
        public var toScene:AffineTransform;

        /** Whether the mesh is mirrored in the scene. Read only. */
        public var isMirror:Boolean;

        private var _meshPoints:Vector.<Number>;

        /**
         * Points that nothing has moved yet.
         *
         * @param meshPoints the mesh's points; they stay as they are
         * @param toScene takes them to the scene
         */
        public function DeformedPoints(meshPoints:Vector.<Number>, toScene:AffineTransform)
        {
            _meshPoints = meshPoints;
            reset(toScene);
        }

        /** Puts the points back where the mesh has them. @param toScene takes them to the scene from there */
        public function reset(toScene:AffineTransform):void
        {
            points = _meshPoints.slice();
            this.toScene = toScene;
            isMirror = toScene.isMirror;
        }

        /**
         * The steps that move some points by a morph target.
         *
         * @param first the index of the first point that moves
         * @param weight the target's
         * @param target the points of the target; without a base, the displacements to them
         * @param base the points before any target has moved them; null for none
         */
        public function morphing(first:int, weight:Number, target:Vector.<Number>, base:Vector.<Number>):Steps
        {
            return new StepSequence().slices(target.length, 3 * POINTS_PER_STEP, function(from:int, end:int):void
                {
                    for (var i:int = from; i < end; i++)
                    {
                        points[int(3 * first + i)] += weight * (base == null ? target[i] : target[i] - base[i]);
                    }
                });
        }

        /**
         * The steps that move all points to where their joints put them in the scene. The weights of a point are divided by their sum. A point without
         * weights follows the first joint.
         *
         * @param influences says which joints each point follows
         * @param jointMatrices what takes points to the scene, by each joint
         * @param budget what the file may cost
         * @param skin the skin's place in the file, for errors
         */
        public function skinning(influences:JointInfluences, jointMatrices:Vector.<AffineTransform>, budget:FileBudget, skin:Object):Steps
        {
            budget.spendNumbers(2 * influences.joints.length, skin);
            return new StepSequence().slices(points.length / 3, SKINNED_PER_STEP, function(first:int, end:int):void
                {
                    refuseModelIf(!skinPoints(influences, jointMatrices, first, end), budget.modelName,
                            "it moves points too far: their coordinates are not finite numbers", skin);
                }).call(function():void
                {
                    toScene = new AffineTransform();
                    isMirror = jointMatrices[0].isMirror;
                });
        }

        // Returns whether all new coordinates are finite.
        private function skinPoints(influences:JointInfluences, jointMatrices:Vector.<AffineTransform>, first:int, end:int):Boolean
        {
            var moved:Vector.<Number> = new Vector.<Number>(3);
            var differences:Number = 0;
            for (var i:int = first; i < end; i++)
            {
                var at:int = 3 * i;
                var sum:Number = 0;
                var x:Number = 0;
                var y:Number = 0;
                var z:Number = 0;
                for (var k:int = influences.offsets[i]; k < influences.offsets[int(i + 1)]; k++)
                {
                    var weight:Number = influences.weights[k];
                    jointMatrices[influences.joints[k]].transformPoints(points, i, i + 1, moved, 0);
                    sum += weight;
                    x += weight * moved[0];
                    y += weight * moved[1];
                    z += weight * moved[2];
                }
                if (sum == 0)
                {
                    jointMatrices[0].transformPoints(points, i, i + 1, points, i);
                }
                else
                {
                    points[at] = x / sum;
                    points[int(at + 1)] = y / sum;
                    points[int(at + 2)] = z / sum;
                }
                var all:Number = points[at] + points[int(at + 1)] + points[int(at + 2)];
                differences += all - all; // 0, but NaN if the sum is not finite, and then differences stays NaN
            }
            return differences == 0;
        }
    }
}
