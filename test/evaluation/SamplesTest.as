package evaluation
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;

    public class SamplesTest
    {
        [Test]
        public function medianIsTheMiddleOne():void
        {
            assertEquals(3, new Samples([9, 1, 3]).median);
            assertEquals(2.5, new Samples([4, 1, 3, 2]).median);
            assertEquals("numbers, not words", 10, new Samples([9, 10, 100]).median);
        }

        [Test]
        public function aFifthAtEitherEndDoesNotCount():void
        {
            var samples:Samples = new Samples([10, 1, 11, 12, 99]);
            assertEquals(10, samples.low);
            assertEquals(12, samples.high);
            var few:Samples = new Samples([10, 1, 99]);
            assertEquals(1, few.low);
            assertEquals(99, few.high);
            assertEquals("two of ten", 3, new Samples([1, 2, 3, 4, 5, 6, 7, 8, 9, 10]).low);
        }

        [Test]
        public function spreadIsHalfTheRangeInPartsOfTheMedian():void
        {
            assertEquals(0.25, new Samples([4, 3, 5]).spread);
        }

        [Test]
        public function whatIsTooFarApartOrTooShortIsNotSteady():void
        {
            assertTrue(new Samples([10, 11, 12]).isSteady);
            assertFalse(new Samples([10, 11, 20]).isSteady);
            assertFalse("less than nothing is left of it", new Samples([-1, 0, 1]).isSteady);
        }
    }
}
