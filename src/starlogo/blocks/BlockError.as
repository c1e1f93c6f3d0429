package starlogo.blocks
{
    /** What is wrong with the use of a block, in words for students. */
    public class BlockError extends Error
    {
        private var _block:String;

        /**
         * An error about the use of a block.
         *
         * @param block the words on the block
         * @param problem what follows them in a sentence
         */
        public function BlockError(block:String, problem:String)
        {
            super("The block \"" + block + "\" " + problem);
            name = "BlockError";
            _block = block;
        }

        /** The words on the block. */
        public function get block():String
        {
            return _block;
        }
    }
}
