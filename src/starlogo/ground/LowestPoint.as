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
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        private var _up:Vector3D;

        // How high the point is along the direction, less what may be rounded.
        private var _height:Number = 0;

        /** @param up the direction, a unit vector. It is kept: <code>find()</code> takes it as it is then, and it must not change after that */
        public function LowestPoint(up:Vector3D)
        {
            _up = up;
        }

        /** Finds the point. */
        public function find(shape:ConvexShape):void
        {
            var at:int = shape.support(_up, -1);
            x = shape.x + shape.points[at] - shape.radius * _up.x;
            y = shape.y + shape.points[int(at + 1)] - shape.radius * _up.y;
            z = shape.z + shape.points[int(at + 2)] - shape.radius * _up.z;
            _height = x * _up.x + y * _up.y + z * _up.z - Tolerances.EXTENTS * (shape.extent + shape.radius + Math.abs(x) + Math.abs(y) + Math.abs(z));
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
