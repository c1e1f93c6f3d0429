package starlogo.intersection.ray
{
    /**
     * Where a ray crosses the surface of one shape: the crossings, in any order.
     *
     * @private
     */
    public final class RayCrossings
    {
        /** The number of crossings. */
        public var count:int = 0;

        /** The first <code>count</code> are the crossings. The others are for the next ray. */
        public var items:Vector.<RayCrossing> = new Vector.<RayCrossing>();

        /** Adds a crossing, and returns it to be written. If there is none after all, reduce <code>count</code> by 1. */
        public function add():RayCrossing
        {
            if (count == items.length)
            {
                items.push(new RayCrossing());
            }
            return items[count++];
        }

        /** Adds that a ray begins inside of the shape. */
        public function addInside(ray:Ray):void
        {
            var start:RayCrossing = add();
            start.setToStart(ray);
            start.side = RayCrossing.INSIDE;
            start.rounding = 0;
        }

        /**
         * Adds where a ray enters a convex shape and where it leaves it. If it begins inside, it enters where it begins. If it ends inside, it does not
         * leave.
         *
         * @param span the part of the ray's line inside of the shape
         * @param rounding how far a distance may be wrong because of rounding
         */
        public function addSpan(ray:Ray, span:RaySpan, rounding:Number):void
        {
            var entry:RayCrossing = add();
            if (!entry.setToEntry(ray, span))
            {
                count--;
                return;
            }
            entry.side = RayCrossing.ENTERS;
            entry.rounding = entry.distance > ray.from ? rounding : 0;
            var exit:RayCrossing = add();
            exit.side = RayCrossing.LEAVES;
            exit.rounding = rounding;
            if (!exit.setToExit(ray, span, entry))
            {
                count--;
            }
        }
    }
}
