package starlogo.geometry
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;

    public class CompareVectorsTest
    {
        [Test]
        public function vectorsAreInOrderByXThenYThenZ():void
        {
            for (var first:int = 0; first < 27; first++)
            {
                for (var second:int = 0; second < 27; second++)
                {
                    var order:int = compareVectors(place(first), place(second));
                    assertEquals(first + ", " + second, true, first < second ? order < 0 : first > second ? order > 0 : order == 0);
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
