package flash.errors
{
    /** There is no more memory. */
    public class MemoryError extends Error
    {
        public function MemoryError(message:String = "", id:int = 0)
        {
            super(message, id);
            name = "MemoryError";
        }
    }
}
