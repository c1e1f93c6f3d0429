package starlogo.broadphase
{
    /**
     * Columns of middles, each with a circle on the ground around it, in patches.
     *
     * @private
     */
    public class Circles extends Points
    {
        /** By row: the radius of a circle that encloses the row's shape. */
        public var radius:Vector.<Number> = new Vector.<Number>();

        /** @inheritDoc */
        override public function grow(length:int):void
        {
            super.grow(length);
            if (length > radius.length)
            {
                radius.length = length;
            }
        }
    }
}
