package support
{
    import flash.display.Stage;

    /** The stage, for tests of what is shown on it. What a test puts there it takes away again. */
    public final class TestStage
    {
        /** The test SWF's. It sets it before any test. */
        public static var stage:Stage;
    }
}
