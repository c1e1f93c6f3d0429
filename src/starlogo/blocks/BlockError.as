package starlogo.blocks
{
    /** Thrown if a block is used wrongly. The message is written for students. */
    public class BlockError extends Error
    {
        private var _block:String;

        /**
         * Creates an error for a block.
         *
         * @param block the words on the block
         * @param problem follows these words in the message's sentence
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
