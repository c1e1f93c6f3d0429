package starlogo.intersection.distance
{
    /**
     * How far two shapes are apart, and the two points that are as near to each other: one on each, or, where the shapes touch, twice a point of
     * both. Plain fields, for reuse; also what a kernel starts from.
     *
     * @private
     */
    public final class ClosestPair
    {
        /** How far the points are apart: 0 if the shapes touch. */
        public var distance:Number = 0;

        /** The point of the first shape. */
        public var aX:Number = 0;

        /** @copy #aX */
        public var aY:Number = 0;

        /** @copy #aX */
        public var aZ:Number = 0;

        /** The point of the second shape. */
        public var bX:Number = 0;

        /** @copy #bX */
        public var bY:Number = 0;

        /** @copy #bX */
        public var bZ:Number = 0;

        /** For separate: from the second core's closest point to the first's, which is aX, aY, aZ. */
        public var gapX:Number = 0;

        /** @copy #gapX */
        public var gapY:Number = 0;

        /** @copy #gapX */
        public var gapZ:Number = 0;

        /** For separate: how far the first shape reaches from its core. */
        public var radiusA:Number = 0;

        /** For separate: how far the second does. */
        public var radiusB:Number = 0;

        /** At the origin, touching. */
        public function ClosestPair()
        {
        }

        /**
         * Sets distance and points from the gap between the cores and the radii around these. Where shapes overlap, the point is in the middle of
         * what both cover of the line through the closest points of the cores. Numbers are fields, because V8 makes an object of each that is passed.
         */
        public function separate():void
        {
            var x:Number = gapX;
            var y:Number = gapY;
            var z:Number = gapZ;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            var atA:Number = radiusA;
            var atB:Number = length - radiusB;
            distance = atB - atA;
            if (!(distance > 0))
            {
                distance = 0;
                var low:Number = atB > -radiusA ? atB : -radiusA;
                var high:Number = length + radiusB;
                high = high < radiusA ? high : radiusA;
                atA = atB = (low + high) / 2;
            }
            if (length > 0)
            {
                x /= length;
                y /= length;
                z /= length;
            }
            bX = aX - atB * x;
            bY = aY - atB * y;
            bZ = aZ - atB * z;
            aX -= atA * x;
            aY -= atA * y;
            aZ -= atA * z;
        }

        /** Makes it that of the same shapes in the other order. */
        public function turn():void
        {
            var x:Number = aX;
            var y:Number = aY;
            var z:Number = aZ;
            aX = bX;
            aY = bY;
            aZ = bZ;
            bX = x;
            bY = y;
            bZ = z;
        }

        /** Makes it that of shapes that touch in spite of a gap: in the middle of the gap. */
        public function close():void
        {
            distance = 0;
            aX = bX = (aX + bX) / 2;
            aY = bY = (aY + bY) / 2;
            aZ = bZ = (aZ + bZ) / 2;
        }
    }
}
