package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.gltf.GltfFile;
    import starlogo.models.gltf.GltfScene;

    /**
     * A model from a glTF 2.0 file, binary (.glb) or JSON (.gltf).
     *
     * <p>The model is the scene that the file shows, or all scenes if the file names none. All transforms of the nodes are applied, and a
     * mesh may be placed many times. Every primitive with a surface is read: triangles, strips and fans, with or without indices. If there
     * are no surfaces, the points make a model without triangles. Morph targets count by their weights. A skinned mesh is in the rest pose
     * of its joints. Accessors may have any kind of number, be normalised, have gaps between rows, be sparse, or be quantized
     * (KHR_mesh_quantization). Each node with a surface is a mesh with the node's name, or its mesh's if it has none; they are numbered from 0
     * in the order of the scene. A material has its number in the file. Cameras and lights are ignored.
     * GltfAnimations reads animations.</p>
     *
     * <p>A file is refused if it is compressed with Draco or meshopt, or if it requires an unknown extension. Optional extensions are
     * ignored. Extensions for materials, textures and lights are ignored too. A node counts even if it is invisible
     * (KHR_node_visibility). The y axis points up in glTF and is turned to z. In a
     * mirrored node, the corner order of each triangle is reversed, so that triangles still face outwards. Vertices that no triangle uses
     * are left out. Cost: linear in the file and in the geometry that its nodes place.</p>
     */
    public class GltfModel extends Model
    {
        /**
         * Use <code>fromBytes()</code> instead.
         *
         * @copy #fromBytes()
         */
        public function GltfModel(name:String, bytes:ByteArray, upAxis:Object = null, scaling:String = Model.FOOTPRINT, buffers:Object = null)
        {
            super(name, null, null, null, new GltfScene(GltfFile.read(name, bytes, buffers), upAxis, scaling).building().build());
        }

        /**
         * Reads a model from a file's bytes.
         *
         * @param name what agents call the shape, not empty
         * @param bytes the whole file; its position and endianness may change
         * @param upAxis null for y, as the format has it; "x", "z" or a ModelTransform to use that instead
         * @param scaling as for <code>Model</code>
         * @param buffers the files that the buffers of a .gltf file name: a ByteArray under each name; null if there are none
         * @throws ModelError if the file is no glTF 2.0 or is cut off, if it requires an unknown extension, if a buffer is missing, if a
         * number, index or reference is wrong, if a node contains itself, if there is no vertex, or as for <code>Model</code>. The message
         * names the place in the JSON
         */
        public static function fromBytes(name:String, bytes:ByteArray, upAxis:Object = null, scaling:String = Model.FOOTPRINT,
                buffers:Object = null):GltfModel
        {
            return new GltfModel(name, bytes, upAxis, scaling, buffers);
        }
    }
}
