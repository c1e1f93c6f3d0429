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
            var skin:GltfJson = file.json.fileEntry("skins", index);
            var matrices:GltfAccessor = null;
            skin.refuseIf(skin.count("joints") == 0, "expected at least one joint", "joints");
            var accessor:int = skin.reference("inverseBindMatrices", "accessors");
            if (accessor >= 0)
            {
                matrices = file.accessor(accessor, "MAT4");
                matrices.json.refuseIf(matrices.count < skin.count("joints"), "there are " + skin.count("joints") + " joints, but fewer matrices");
                add(matrices);
            }
            slices(skin.count("joints"), JOINTS_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        var transform:AffineTransform = scene.globalTransformOf(skin.indexIn("joints", i, "nodes"));
                        transforms.push(matrices == null ? transform : transform.after(GltfScene.ofColumns(matrices.numbers, 16 * i)));
                    }
                });
        }
    }
}
