package flash.errors
{
    /** There is nothing more to read. */
    public class EOFError extends IOError
    {
        public function EOFError(message:String = "", id:int = 0)
        {
            super(message, id);
            name = "EOFError";
        }
    }
}
