package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.intersection.contact.ContactPoint;

    /**
     * Finds the point of a box, or of some corners, that is farthest against a normal. If there are several, it is their middle.
     *
     * @private
     */
    public final class DeepestPoint
    {
        // Corners are equally deep if their depths differ by less than this fraction.
        private static const LEVEL:Number = 1e-12;

        /** The point. */
        public var point:Vector3D = new Vector3D();

        /** Finds the point of a box. */
        public function findOfBox(box:Box, normal:ContactPoint):void
        {
            point.copyFrom(box.center);
            goDown(normal.along(box.axisX), box.axisX, box.halfX);
            goDown(normal.along(box.axisY), box.axisY, box.halfY);
            goDown(normal.along(box.axisZ), box.axisZ, box.halfZ);
        }

        /** Finds the point of some corners. */
        public function findOfCorners(corners:Vector.<Number>, end:int, normal:ContactPoint):void
        {
            normal.measure(corners, 0, end);
            var most:Number = normal.least + LEVEL * (normal.greatest - normal.least);
            var count:int = 0;
            var x:Number = 0;
            var y:Number = 0;
            var z:Number = 0;
            for (var i:int = 0; i < end; i += 3)
            {
                if (normal.normalX * corners[i] + normal.normalY * corners[int(i + 1)] + normal.normalZ * corners[int(i + 2)] <= most)
                {
                    x += corners[i];
                    y += corners[int(i + 1)];
                    z += corners[int(i + 2)];
                    count++;
                }
            }
            point.setTo(x / count, y / count, z / count);
        }

        // Goes half of a box's length against a normal, but not along an axis that is perpendicular to it.
        private function goDown(along:Number, axis:Vector3D, half:Number):void
        {
            var by:Number = along > LEVEL ? -half : along < -LEVEL ? half : 0;
            point.x += by * axis.x;
            point.y += by * axis.y;
            point.z += by * axis.z;
        }
    }
}
