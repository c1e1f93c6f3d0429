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

        /** Makes sure that there are at least this many rows. New rows are 0. */
        public function grow(length:int):void
        {
            if (length > x.length)
            {
                x.length = y.length = z.length = length;
            }
        }
    }
}
