package support
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import starlogo.models.ModelError;

    /** What tests say about models that must not load. */
    public final class Failures
    {
        /** The ModelError that an action throws; anything else fails the test. */
        public static function of(action:Function):ModelError
        {
            try
            {
                action();
            }
            catch (error:ModelError)
            {
                return error;
            }
            fail("expected a ModelError");
            return null;
        }

        /** Asserts that an action throws a ModelError of a place, with some words in its message. */
        public static function assertFails(place:String, words:String, action:Function):void
        {
            var error:ModelError = of(action);
            assertEquals(error.message, place, error.place);
            assertTrue(error.message, error.message.indexOf(words) >= 0);
        }
    }
}
