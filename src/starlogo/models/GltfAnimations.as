package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.gltf.GltfAnimationReader;
    import starlogo.models.gltf.GltfFile;

    /**
     * The animations of a glTF file, as poses of the GltfModel of the same file.
     *
     * <p>Nodes that move, turn and scale, skins, and the weights of morph targets are animated, with linear, stepped and cubic keys. What
     * extensions animate (KHR_animation_pointer) is ignored. An animation of a node with a matrix is refused.</p>
     */
    public final class GltfAnimations extends ModelAnimations
    {
        /**
         * Reads the animations of a file. If there are any, it reads the scene too.
         *
         * @param name the model's name, for errors
         * @param bytes the whole file; its position and endianness may change
         * @param upAxis the same as for the GltfModel
         * @param buffers the same as for the GltfModel
         * @throws ModelError as GltfModel, or if an animation is wrong
         */
        public function GltfAnimations(name:String, bytes:ByteArray, upAxis:Object = null, buffers:Object = null)
        {
            super(GltfAnimationReader.allIn(GltfFile.read(name, bytes, buffers), upAxis));
        }
    }
}
