package starlogo.intersection
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;

    public class IsAfterTest
    {
        [Test]
        public function placesAreInOrderByXThenYThenZ():void
        {
            for (var first:int = 0; first < 27; first++)
            {
                for (var second:int = 0; second < 27; second++)
                {
                    assertEquals(first + ", " + second, first > second, isAfter(place(first), place(second)));
                }
            }
        }

        // One of 27 places, in this order.
        private static function place(number:int):Vector3D
        {
            return new Vector3D(int(number / 9), int(number / 3) % 3, number % 3);
        }
    }
}
