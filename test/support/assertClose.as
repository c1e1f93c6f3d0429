package support
{
    import org.flexunit.asserts.fail;

    /**
     * Expects a number within a tolerance.
     *
     * @param expected the number
     * @param actual what was computed
     * @param tolerance the greatest difference
     * @param message begins the failure's message
     */
    public function assertClose(expected:Number, actual:Number, tolerance:Number, message:String = ""):void
    {
        if (!(Math.abs(actual - expected) <= tolerance))
        {
            fail(message + " expected " + expected + " within " + tolerance + ", not " + actual);
        }
    }
}
