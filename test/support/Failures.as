package support
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import starlogo.models.ModelError;

    /** What tests say about models that must not load. */
    public final class Failures
    {
        /** The ModelError that a call throws; anything else fails the test. */
        public static function of(call:Function, ...args):ModelError
        {
            try
            {
                call.apply(null, args);
            }
            catch (error:ModelError)
            {
                return error;
            }
            fail("expected a ModelError");
            return null;
        }

        /** Asserts that a call throws a ModelError of a place, with some words in its message. */
        public static function assertFails(place:String, words:String, call:Function, ...args):void
        {
            var error:ModelError = of.apply(null, [call].concat(args));
            assertEquals(error.message, place, error.place);
            assertTrue(error.message, error.message.indexOf(words) >= 0);
        }
    }
}
