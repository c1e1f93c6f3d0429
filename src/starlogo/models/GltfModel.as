package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.gltf.GltfFile;
    import starlogo.models.gltf.GltfReader;
    import starlogo.steps.finish;

    /**
     * A model from a glTF 2.0 file, binary (.glb) or JSON (.gltf).
     *
     * <p>Read is the scene that the file shows, or all where it says of none that it does: its nodes with all their transforms, the meshes that
     * they have, as often as they do, and of these every primitive with a surface: triangles, strips and fans, with indices or without. Where
     * there are no surfaces, the points make a model without triangles. Morph targets count by their weights, and what has a skin is where its
     * joints have it at rest. Accessors may be of any kind of number, normalised, in rows with gaps, sparse, and of quantized meshes
     * (KHR_mesh_quantization). Materials, cameras, lights and animations have no part in collisions.</p>
     *
     * <p>What is compressed with Draco or meshopt is not read, nor what needs an extension that is not known here; extensions that a file can do
     * without, and those of materials, textures and lights, are passed over. y is up, and turned to z. Triangles of a mirrored node are turned
     * round, so that they still face outwards. Vertices that no triangle uses are left out. Cost: linear in the file and what its nodes
     * place.</p>
     */
    public class GltfModel extends Model
    {
        /**
         * The model comes from <code>fromBytes()</code>; the constructor serves that.
         *
         * @copy #fromBytes()
         */
        public function GltfModel(name:String, bytes:ByteArray, upAxis:Object = null, scaling:String = Model.FOOTPRINT, buffers:Object = null)
        {
            super(name, ORIGIN);
            var file:GltfFile = new GltfFile(name, bytes, null);
            finish(file);
            for each (var uri:String in file.missing)
            {
                file.setBuffer(uri, entryOf(buffers, uri) as ByteArray, "\"" + TextTokens.shorten(uri) +
                        "\" is beside the file, and was not given: a ModelLoader's load() fetches it");
            }
            setShape(new GltfReader(name, file, upAxis).readShape(scaling, upAxis as ModelTransform));
        }

        /**
         * Reads a model from a file's bytes.
         *
         * @param name what agents call the shape, not empty
         * @param bytes the whole file; its position and endianness are left anyhow
         * @param upAxis null for y, as the format has it; "x", "z" or a ModelTransform in place of that
         * @param scaling as for <code>Model</code>
         * @param buffers ByteArrays of the files beside a .gltf file that its buffers name, by these names; null if there are none
         * @throws ModelError if the file is no glTF 2.0, is cut off, needs an extension that is not known, a buffer is missing, a number, index or
         *     reference is wrong, nodes are in themselves, there is no vertex, or as for <code>Model</code>; it names the place in the JSON
         */
        public static function fromBytes(name:String, bytes:ByteArray, upAxis:Object = null, scaling:String = Model.FOOTPRINT,
                buffers:Object = null):GltfModel
        {
            return new GltfModel(name, bytes, upAxis, scaling, buffers);
        }
    }
}
