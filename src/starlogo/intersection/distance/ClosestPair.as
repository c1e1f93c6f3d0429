package starlogo.intersection.distance
{
    import starlogo.geometry.Placement;

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

        /**
         * Says whether the shapes touch, in spite of what rounding has made of the distance: if they do, it is 0, and the point in the middle of
         * the gap; if not, it is more than 0.
         */
        public function settle(areTouching:Boolean):void
        {
            if (areTouching)
            {
                distance = 0;
                aX = bX = (aX + bX) / 2;
                aY = bY = (aY + bY) / 2;
                aZ = bZ = (aZ + bZ) / 2;
            }
            else if (!(distance > 0))
            {
                distance = Number.MIN_VALUE;
            }
        }

        /** Takes the points to where a placement puts the space that they are in. */
        public function place(placement:Placement):void
        {
            var size:Number = placement.size;
            var x:Number = aX * size;
            var y:Number = aY * size;
            var z:Number = aZ * size;
            aX = placement.r00 * x + placement.r01 * y + placement.r02 * z + placement.x;
            aY = placement.r10 * x + placement.r11 * y + placement.r12 * z + placement.y;
            aZ = placement.r20 * x + placement.r21 * y + placement.r22 * z + placement.z;
            x = bX * size;
            y = bY * size;
            z = bZ * size;
            bX = placement.r00 * x + placement.r01 * y + placement.r02 * z + placement.x;
            bY = placement.r10 * x + placement.r11 * y + placement.r12 * z + placement.y;
            bZ = placement.r20 * x + placement.r21 * y + placement.r22 * z + placement.z;
        }

        /** Takes over the points of another. */
        public function copyPoints(other:ClosestPair):void
        {
            aX = other.aX;
            aY = other.aY;
            aZ = other.aZ;
            bX = other.bX;
            bY = other.bY;
            bZ = other.bZ;
        }
    }
}
