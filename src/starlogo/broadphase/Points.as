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
    }
}
