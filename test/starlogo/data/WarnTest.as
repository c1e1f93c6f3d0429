package starlogo.data
{
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;

    /** What is said of probable mistakes. */
    public class WarnTest
    {
        /** A model that is bound again, as whenever another one has loaded, says no more. */
        [Test]
        public function saysEachMessageOnce():void
        {
            assertTrue(warn("a test says this, and nothing is wrong"));
            assertFalse(warn("a test says this, and nothing is wrong"));
            assertTrue(warn("a test says that, and nothing is wrong"));
        }
    }
}
