package flash.errors
{
    /** A method is not for this object, or not now. */
    public class IllegalOperationError extends Error
    {
        public function IllegalOperationError(message:String = "", id:int = 0)
        {
            super(message, id);
            name = "IllegalOperationError";
        }
    }
}
