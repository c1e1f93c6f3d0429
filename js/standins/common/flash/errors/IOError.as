package flash.errors
{
    /** Something could not be read or written. */
    public class IOError extends Error
    {
        public function IOError(message:String = "", id:int = 0)
        {
            super(message, id);
            name = "IOError";
        }
    }
}
