package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Placement;

    /**
     * The distance of two shapes a and b and their closest points, as a record. If the shapes touch, both points are one point of both shapes.
     *
     * @private
     */
    public final class ClosestPoints
    {
        /** The distance of the two points: 0 if the shapes touch. A search for a closer pair looks only for a distance below it. */
        public var distance:Number = Infinity;

        /** The point of a. */
        public var aX:Number = 0;
        public var aY:Number = 0;
        public var aZ:Number = 0;

        /** The point of b. */
        public var bX:Number = 0;
        public var bY:Number = 0;
        public var bZ:Number = 0;

        /**
         * Sets the distance and the points from the gap between two cores. If the shapes overlap, both points become one point. It lies on the line
         * through the cores' closest points, in the middle of the part inside of both shapes.
         */
        public function setFromGap(gap:CoreGap):void
        {
            var x:Number = gap.x;
            var y:Number = gap.y;
            var z:Number = gap.z;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            // how far the two points are from the closest point of a's core, towards b
            var atA:Number = gap.radiusA;
            var atB:Number = length - gap.radiusB;
            distance = length - (gap.radiusA + gap.radiusB);
            if (!(distance > 0))
            {
                distance = 0;
                var low:Number = atB > -atA ? atB : -atA;
                var high:Number = length + gap.radiusB;
                high = high < atA ? high : atA;
                atA = atB = (low + high) / 2;
            }
            if (length > 0)
            {
                x /= length;
                y /= length;
                z /= length;
            }
            aX = gap.pointX - atA * x;
            aY = gap.pointY - atA * y;
            aZ = gap.pointZ - atA * z;
            bX = gap.pointX - atB * x;
            bY = gap.pointY - atB * y;
            bZ = gap.pointZ - atB * z;
        }

        /**
         * Writes the contact of two shapes that do not touch: its point is half way between the two points, and its depth is 0. If the points are the same,
         * or no points were found, its point and its normal stay.
         */
        public function writeContact(out:ContactPoint):void
        {
            var x:Number = aX - bX;
            var y:Number = aY - bY;
            var z:Number = aZ - bZ;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            out.depth = 0;
            if (distance < Infinity && length > 0)
            {
                out.x = bX + x / 2;
                out.y = bY + y / 2;
                out.z = bZ + z / 2;
                out.setNormal(x / length, y / length, z / length);
            }
        }

        /** Exchanges the two shapes. */
        public function swap():void
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
         * Corrects what rounding has made of the distance, when another test knows whether the shapes touch. If they touch, the distance
         * becomes 0 and both points move to the middle of the gap. If not, the distance becomes more than 0.
         */
        public function correct(areTouching:Boolean):void
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

        /** Sets both points to one, and the distance to 0. */
        public function setPoint(point:Vector3D):void
        {
            distance = 0;
            aX = bX = point.x;
            aY = bY = point.y;
            aZ = bZ = point.z;
        }

        /** Transforms the points by a placement. */
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

        /** Copies another pair. */
        public function copyFrom(other:ClosestPoints):void
        {
            distance = other.distance;
            aX = other.aX;
            aY = other.aY;
            aZ = other.aZ;
            bX = other.bX;
            bY = other.bY;
            bZ = other.bZ;
        }
    }
}
