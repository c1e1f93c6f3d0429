package starlogo.models.gltf
{
    import starlogo.geometry.AffineTransform;
    import starlogo.steps.StepSequence;

    /** Finds how the joints of a skin move points, in steps: at rest or in a pose, as the scene's nodes are. */
    internal final class GltfJoints extends StepSequence
    {
        private static const JOINTS_PER_STEP:int = 200;

        /** A transform for each joint, when no step is left. */
        public var transforms:Vector.<AffineTransform> = new Vector.<AffineTransform>();

        /**
         * @param file the file
         * @param scene knows the joints' places
         * @param index the skin's index
         */
        public function GltfJoints(file:GltfFile, scene:GltfScene, index:int)
        {
            var json:GltfJson = file.json;
            var place:String = "skins[" + index + "]";
            var skin:Object = json.entry("skins", index);
            var joints:Array = json.listIn(skin, "joints", place);
            json.refuseIf(joints.length == 0, "expected at least one joint", place + ".joints");
            var matrices:GltfAccessor = null;
            var accessor:int = json.reference(skin, "inverseBindMatrices", place, "accessors");
            if (accessor >= 0)
            {
                matrices = file.accessor(accessor, "MAT4");
                json.refuseIf(matrices.count < joints.length, "there are " + joints.length + " joints, but fewer matrices", matrices.place);
                add(matrices);
            }
            addSteps(json, scene, joints, place + ".joints", matrices);
        }

        private function addSteps(json:GltfJson, scene:GltfScene, joints:Array, place:String, matrices:GltfAccessor):void
        {
            slices(joints.length, JOINTS_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        var transform:AffineTransform = scene.globalTransformOf(json.checkedIndex(joints[i], place + "[" + i + "]", "nodes"));
                        transforms.push(matrices == null ? transform : transform.after(GltfScene.ofColumns(matrices.numbers, 16 * i)));
                    }
                });
        }
    }
}
