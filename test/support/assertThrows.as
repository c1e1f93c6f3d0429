package support
{
    import flash.utils.getQualifiedClassName;
    import org.flexunit.asserts.fail;

    /**
     * Calls a function and expects it to throw.
     *
     * @param errorClass the class that the error must have
     * @param message a RegExp that its message must match, or a String that the message must contain
     * @param call the function
     * @param args its arguments
     */
    public function assertThrows(errorClass:Class, message:*, call:Function, ...args):void
    {
        try
        {
            call.apply(null, args);
        }
        catch (error:Error)
        {
            if (!(error is errorClass) || !(message is RegExp ? message.test(error.message) : error.message.indexOf(message) >= 0))
            {
                fail("expected a " + getQualifiedClassName(errorClass) + " that matches " + message + ", not " + error);
            }
            return;
        }
        fail("expected a " + getQualifiedClassName(errorClass) + " that matches " + message + ", but nothing was thrown");
    }
}
