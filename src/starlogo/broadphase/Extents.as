package starlogo.broadphase
{
    /**
     * Columns of axis-aligned extents: the middle and the half lengths of each row, in patches, and the level of bins that fits the row.
     * BinLevels.assign finds the level.
     *
     * @private
     */
    public final class Extents extends Points
    {
        /** The radius of a circle on the ground around the extents. */
        public var radius:Vector.<Number> = new Vector.<Number>();

        /** Half the length along x. */
        public var halfX:Vector.<Number> = new Vector.<Number>();

        /** Half the length along y. */
        public var halfY:Vector.<Number> = new Vector.<Number>();

        /** Half the length along z. */
        public var halfZ:Vector.<Number> = new Vector.<Number>();

        /** The index of the level of bins that fits; 0 if it is not known yet. */
        public var level:Vector.<int> = new Vector.<int>();

        /** Makes room for so many rows, which are more than before. New rows are points at the origin without a level. */
        override public function grow(length:int):void
        {
            super.grow(length);
            radius.length = halfX.length = halfY.length = halfZ.length = level.length = length;
        }
    }
}
