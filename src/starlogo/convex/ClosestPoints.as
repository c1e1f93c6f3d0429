package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

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
        public var a:Vector3D = new Vector3D();

        /** The point of b. */
        public var b:Vector3D = new Vector3D();

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
            a.x = gap.point.x - atA * x;
            a.y = gap.point.y - atA * y;
            a.z = gap.point.z - atA * z;
            b.x = gap.point.x - atB * x;
            b.y = gap.point.y - atB * y;
            b.z = gap.point.z - atB * z;
        }

        /**
         * Writes the contact of two shapes that do not touch: its point is half way between the two points, and its depth is 0. If the points are the same,
         * or no points were found, its point and its normal stay.
         */
        public function writeContact(out:ContactPoint):void
        {
            var x:Number = a.x - b.x;
            var y:Number = a.y - b.y;
            var z:Number = a.z - b.z;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            out.depth = 0;
            if (distance < Infinity && length > 0)
            {
                out.x = b.x + x / 2;
                out.y = b.y + y / 2;
                out.z = b.z + z / 2;
                out.setNormal(x / length, y / length, z / length);
            }
        }

        /** Exchanges the two shapes. */
        public function swap():void
        {
            var point:Vector3D = a;
            a = b;
            b = point;
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
                a.x = b.x = (a.x + b.x) / 2;
                a.y = b.y = (a.y + b.y) / 2;
                a.z = b.z = (a.z + b.z) / 2;
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
            a.copyFrom(point);
            b.copyFrom(point);
        }

        /** Transforms the points by a placement. The distance stays: it is in the new space already. */
        public function placePoints(placement:Placement):void
        {
            placement.place(a, a);
            placement.place(b, b);
        }

        /** Copies another pair. */
        public function copyFrom(other:ClosestPoints):void
        {
            distance = other.distance;
            a.copyFrom(other.a);
            b.copyFrom(other.b);
        }
    }
}
