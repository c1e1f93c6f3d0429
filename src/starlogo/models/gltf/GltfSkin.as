package starlogo.models.gltf
{
    import starlogo.geometry.AffineTransform;
    import starlogo.steps.StepSequence;

    /** The joints of a glTF skin, where the nodes of the scene are, at rest or in a pose. Its steps find what each joint does to points. */
    internal final class GltfSkin extends StepSequence
    {
        private static const JOINTS_PER_STEP:int = 200;

        /** What each joint does to points, when no step is left. */
        public var palette:Vector.<AffineTransform> = new Vector.<AffineTransform>();

        /**
         * @param file the file
         * @param scene knows the nodes' transforms
         * @param index the skin's index
         */
        public function GltfSkin(file:GltfFile, scene:GltfScene, index:int)
        {
            var skin:GltfJson = file.json.fileEntry("skins", index);
            var count:int = skin.count("joints");
            skin.refuseIf(count == 0, "expected at least one joint", "joints");
            var accessor:int = skin.reference("inverseBindMatrices", "accessors");
            var matrices:GltfAccessor = accessor < 0 ? null : file.accessor(accessor, "MAT4");
            if (matrices != null)
            {
                matrices.json.refuseIf(matrices.count < count, "there are " + count + " joints, but fewer matrices");
                add(matrices);
            }
            slices(count, JOINTS_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        var transform:AffineTransform = scene.globalTransformOf(skin.indexIn("joints", i, "nodes"));
                        palette.push(matrices == null ? transform : transform.after(GltfScene.ofColumns(matrices.numbers, 16 * i)));
                    }
                });
        }
    }
}
