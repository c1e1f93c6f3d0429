package starlogo.models
{
    import org.flexunit.asserts.assertEquals;

    public class NextOfTwoTest
    {
        [Test]
        public function findsTheNearerOfTheTwo():void
        {
            var next:NextOfTwo = new NextOfTwo("a b'c\"d'", "\"", "'");
            var places:Array = [];
            for (var place:int = next.after(0); place < 8; place = next.after(place + 1))
            {
                places.push(place);
            }
            assertEquals("3,5,7", places.join());
        }

        [Test]
        public function theEndIsWhereNeitherIs():void
        {
            assertEquals(3, new NextOfTwo("abc", " ", "\n").after(0));
            assertEquals(0, new NextOfTwo("", " ", "\n").after(0));
            var next:NextOfTwo = new NextOfTwo("a b", " ", "\n");
            assertEquals(1, next.after(1));
            assertEquals(3, next.after(2));
        }
    }
}
