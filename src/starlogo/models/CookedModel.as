package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.steps.finish;

    /**
     * A model from a cooked file: what <code>GreatLand.bake()</code>, <code>./antw bake</code> or <code>starlogo-bake</code> made of a model's
     * source. It is the same as the source's, to the last bit, and a GreatLand that it is added to need not compute what the file has.
     *
     * <p>The file is checked as docs/cooked.md says. Its up axis, transform and scaling are in it. Cost: linear in the file.</p>
     */
    public class CookedModel extends Model
    {
        /**
         * The model comes from <code>fromBytes()</code>; the constructor serves that.
         *
         * @copy #fromBytes()
         */
        public function CookedModel(name:String, bytes:ByteArray)
        {
            super(name, ORIGIN);
            var load:CookedLoad = new CookedLoad(name, bytes);
            finish(load);
            load.giveTo(this);
        }

        /**
         * Reads a model from a file's bytes.
         *
         * @param name what agents call the shape, not empty
         * @param bytes the whole file, which is left as it is but for position and endianness
         * @throws ModelError if it is no cooked file, or one that is damaged, of another version, or forged so that it makes no model
         */
        public static function fromBytes(name:String, bytes:ByteArray):CookedModel
        {
            return new CookedModel(name, bytes);
        }
    }
}
