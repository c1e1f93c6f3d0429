package starlogo.broadphase
{
    /**
     * Columns of points: x, y and z by row.
     *
     * @private
     */
    public class Points
    {
        public var x:Vector.<Number> = new Vector.<Number>();
        public var y:Vector.<Number> = new Vector.<Number>();
        public var z:Vector.<Number> = new Vector.<Number>();

        /** Makes room for so many rows, which are more than before. New rows are 0. */
        public function grow(length:int):void
        {
            x.length = y.length = z.length = length;
        }

        /** The square of the distance of a row's point from the origin. */
        public function squaredLengthOf(row:int):Number
        {
            var alongX:Number = x[row];
            var alongY:Number = y[row];
            var alongZ:Number = z[row];
            return alongX * alongX + alongY * alongY + alongZ * alongZ;
        }
    }
}
