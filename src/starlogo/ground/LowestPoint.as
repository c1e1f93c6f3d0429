package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.geometry.Tolerances;

    /**
     * The lowest point of a convex shape along a direction that counts as upwards. PieceTouchTest leaves out triangles that are lower, without a test
     * by the kernel.
     */
    internal final class LowestPoint
    {
        // How far below the shape a triangle has to be, as a multiple of the margin. ConvexKernel adds Tolerances.CORES of the extents to the margin,
        // which is less than half of Tolerances.SURFACES.
        private static const MARGINS:Number = 1.5;

        /** The point. Read only. */
        public var point:Vector3D = new Vector3D();

        // The direction.
        private var _up:Vector3D = new Vector3D();

        // How high the point is along the direction, less what may be rounded.
        private var _height:Number = 0;

        /**
         * Finds the point.
         *
         * @param up the direction, a unit vector
         */
        public function find(up:Vector3D, shape:ConvexShape):void
        {
            var at:int = shape.support(up, -1);
            var x:Number = shape.x + shape.points[at] - shape.radius * up.x;
            var y:Number = shape.y + shape.points[int(at + 1)] - shape.radius * up.y;
            var z:Number = shape.z + shape.points[int(at + 2)] - shape.radius * up.z;
            // not setTo, because V8 would make objects for the Numbers
            point.x = x;
            point.y = y;
            point.z = z;
            _up.x = up.x;
            _up.y = up.y;
            _up.z = up.z;
            _height = x * up.x + y * up.y + z * up.z - Tolerances.EXTENTS * (shape.extent + shape.radius + Math.abs(x) + Math.abs(y) + Math.abs(z));
        }

        /** Whether a triangle of nine numbers is clearly lower than the shape that was given last, which has the margin of both now. */
        public function isAbove(p:Vector.<Number>, shape:ConvexShape):Boolean
        {
            var most:Number = _height - MARGINS * shape.margin;
            return _up.x * p[0] + _up.y * p[1] + _up.z * p[2] < most && _up.x * p[3] + _up.y * p[4] + _up.z * p[5] < most
                && _up.x * p[6] + _up.y * p[7] + _up.z * p[8] < most;
        }
    }
}
