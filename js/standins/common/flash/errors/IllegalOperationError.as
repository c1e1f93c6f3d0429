package flash.errors
{
    /** Thrown if an object cannot have this method called, or not now. */
    public class IllegalOperationError extends Error
    {
        public function IllegalOperationError(message:String = "", id:int = 0)
        {
            super(message, id);
            name = "IllegalOperationError";
        }
    }
}
