package starlogo.broadphase
{
    /**
     * Columns of axis-aligned extents: where the middle of each row's is, and half its lengths, in patches; and the level of bins that fits them,
     * which Bins.fit finds.
     *
     * @private
     */
    public final class Extents
    {
        /** The middle. */
        public var x:Vector.<Number> = new Vector.<Number>();

        /** @copy #x */
        public var y:Vector.<Number> = new Vector.<Number>();

        /** @copy #x */
        public var z:Vector.<Number> = new Vector.<Number>();

        /** Half the length along x. */
        public var halfX:Vector.<Number> = new Vector.<Number>();

        /** Half the length along y. */
        public var halfY:Vector.<Number> = new Vector.<Number>();

        /** Half the length along z. */
        public var halfZ:Vector.<Number> = new Vector.<Number>();

        /** The radius of a circle on the ground, about the middle, around what has the extents. */
        public var radius:Vector.<Number> = new Vector.<Number>();

        /** The number of the level of bins that fits; 0 for none yet. */
        public var level:Vector.<int> = new Vector.<int>();

        /** No rows. */
        public function Extents()
        {
        }

        /** Half the largest length of a row. */
        public function largestHalf(row:int):Number
        {
            return Math.max(halfX[row], Math.max(halfY[row], halfZ[row]));
        }

        /** Makes sure that there are so many rows; new ones are points at the origin that fit no level yet. */
        public function grow(length:int):void
        {
            if (length > level.length)
            {
                x.length = y.length = z.length = length;
                halfX.length = halfY.length = halfZ.length = radius.length = length;
                level.length = length;
            }
        }
    }
}
