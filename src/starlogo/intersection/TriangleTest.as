package starlogo.intersection
{
    /**
     * Tests triangles, which have numbers, in the order in which something may meet them on its way. Abstract.
     *
     * @private
     */
    public class TriangleTest
    {
        /**
         * How far along the way triangles are tested: where the nearest triangle so far is met. Before the first one, the end of the way. A
         * test that needs no more triangles sets it to -Infinity.
         */
        public var least:Number = 0;

        /**
         * Tests a range of triangles.
         *
         * @param first the first triangle's number
         * @param end the number after the last one
         */
        public function look(first:int, end:int):void
        {
        }
    }
}
