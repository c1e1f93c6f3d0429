package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.cooked.CookedReader;

    /**
     * A model from a cooked file. <code>GreatLand.cook()</code>, <code>./antw cook</code> or <code>starlogo-cook</code> makes the file
     * from a model's source. The model equals the source's model to the last bit. If you add it to a GreatLand, the GreatLand need not
     * compute the results that are in the file.
     *
     * <p>The file is checked as docs/cooked.md says. The file contains the up axis, the transform and the scaling. Cost: linear in the
     * file.</p>
     */
    public class CookedModel extends Model
    {
        /**
         * Use <code>fromBytes()</code> instead.
         *
         * @copy #fromBytes()
         */
        public function CookedModel(name:String, bytes:ByteArray)
        {
            super(name, null, null, null, new CookedReader(name, bytes).building().build());
        }

        /**
         * Reads a model from a file's bytes.
         *
         * @param name what agents call the shape, not empty
         * @param bytes the whole file; its position and endianness may change
         * @throws ModelError if it is no cooked file, or if the file is damaged, of another version, or forged and makes no model
         */
        public static function fromBytes(name:String, bytes:ByteArray):CookedModel
        {
            return new CookedModel(name, bytes);
        }
    }
}
