package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.geometry.Tolerances;

    /** The lowest point of a convex shape along a direction that counts as upwards. What is clearly lower does not touch the shape. */
    internal final class LowestPoint
    {
        // How far below the shape a triangle has to be, as a multiple of the margin. ConvexKernel adds Tolerances.CORES of the extents to the margin,
        // which is less than half of Tolerances.SURFACES.
        private static const MARGINS:Number = 1.5;

        /** The direction: a unit vector. Change it before <code>find()</code>. */
        public var up:Vector3D = new Vector3D(0, 0, 1);

        /** The point. Read only. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** Whether the point of the current shape is known. */
        public var isKnown:Boolean = false;

        // How high the point is along the direction, less what may be rounded.
        private var _height:Number = 0;

        /** Finds the point. */
        public function find(shape:ConvexShape):void
        {
            var at:int = shape.support(up, -1);
            x = shape.x + shape.points[at] - shape.radius * up.x;
            y = shape.y + shape.points[int(at + 1)] - shape.radius * up.y;
            z = shape.z + shape.points[int(at + 2)] - shape.radius * up.z;
            _height = x * up.x + y * up.y + z * up.z - Tolerances.EXTENTS * (shape.extent + shape.radius + Math.abs(x) + Math.abs(y) + Math.abs(z));
            isKnown = true;
        }

        /** Whether a triangle of nine numbers is clearly lower than the shape, which has the margin of both now. The point is known. */
        public function isAbove(p:Vector.<Number>, shape:ConvexShape):Boolean
        {
            var most:Number = _height - MARGINS * shape.margin;
            return up.x * p[0] + up.y * p[1] + up.z * p[2] < most && up.x * p[3] + up.y * p[4] + up.z * p[5] < most
                && up.x * p[6] + up.y * p[7] + up.z * p[8] < most;
        }
    }
}
