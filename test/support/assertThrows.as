package support
{
    import flash.utils.getQualifiedClassName;
    import org.flexunit.asserts.fail;

    /**
     * Calls a function and expects it to throw.
     *
     * @param errorClass the class that the error must have
     * @param message what its message must match
     * @param call the function
     * @param args its arguments
     */
    public function assertThrows(errorClass:Class, message:RegExp, call:Function, ...args):void
    {
        try
        {
            call.apply(null, args);
        }
        catch (error:Error)
        {
            if (!(error is errorClass) || !message.test(error.message))
            {
                fail("expected a " + getQualifiedClassName(errorClass) + " that matches " + message + ", not " + error);
            }
            return;
        }
        fail("expected a " + getQualifiedClassName(errorClass) + " that matches " + message + ", but nothing was thrown");
    }
}
