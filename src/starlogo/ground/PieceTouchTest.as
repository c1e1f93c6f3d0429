package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.intersection.TriangleKernel;

    /**
     * Decides whether the current piece of a model touches the ground. Points of the piece that are under the ground decide about most pieces that touch.
     * Only after that come the triangles near the piece, and those that are clearly below it are left out.
     */
    internal final class PieceTouchTest
    {
        private var _pairs:PieceTrianglePairs;

        // The ground under a point of the piece.
        private var _ground:GroundPoint = new GroundPoint();

        // The ground's normal below the piece, and the piece's lowest point along it.
        private var _normal:Vector3D = new Vector3D();
        private var _lowest:LowestPoint = new LowestPoint();

        // The same along the normal of the contact that was found last.
        private var _wayOut:Vector3D = new Vector3D(0, 0, 1);
        private var _lowestOnWayOut:LowestPoint = new LowestPoint();

        /** @param pairs of the model */
        public function PieceTouchTest(pairs:PieceTrianglePairs)
        {
            _pairs = pairs;
        }

        /** Whether the piece touches the ground. Its triangles are those that come next. */
        public function isTouching():Boolean
        {
            var point:Vector3D = _pairs.pieces.point;
            findGroundUnder(point, _ground);
            if (_ground.height >= point.z + _pairs.origin.z)
            {
                return true;
            }
            // no triangle is near a divisible piece
            if (_pairs.pieces.isDivisible)
            {
                return false;
            }
            _pairs.grid.findNormal(_ground, _normal);
            _lowest.find(_normal, _pairs.kernel.shape);
            return isLowestUnder() || touchesTriangle();
        }

        /** Whether a point of the piece is at least this deep under the ground. */
        public function hasPointUnder(depth:Number):Boolean
        {
            var point:Vector3D = _pairs.pieces.point;
            findGroundUnder(point, _ground);
            return _ground.height - depth >= point.z + _pairs.origin.z;
        }

        /** Notes the normal of a contact of the model. It makes later tests quicker, of the model along this way out. No answer depends on it. */
        public function noteWayOut(contact:ContactPoint):void
        {
            _wayOut.x = contact.normalX;
            _wayOut.y = contact.normalY;
            _wayOut.z = contact.normalZ;
        }

        // Finds the ground under or above a point that is relative to the origin.
        private function findGroundUnder(point:Vector3D, out:GroundPoint):void
        {
            var origin:Placement = _pairs.origin;
            out.x = point.x + origin.x;
            out.y = point.y + origin.y;
            _pairs.grid.findHeight(out);
        }

        // Whether the piece's lowest point is under the ground. Nearly all pieces that reach under the ground do so there.
        private function isLowestUnder():Boolean
        {
            var point:Vector3D = _lowest.point;
            findGroundUnder(point, _ground);
            return _ground.height >= point.z + _pairs.origin.z;
        }

        // Whether the piece touches a triangle near it. A model that is tried along its way out is above nearly all triangles there.
        private function touchesTriangle():Boolean
        {
            var kernel:TriangleKernel = _pairs.kernel;
            var isWayOutMeasured:Boolean = false;
            while (_pairs.nextTriangle())
            {
                var corners:Vector.<Number> = _pairs.triangle.corners;
                if (_lowest.isAbove(corners, kernel.shape) || kernel.plane.keepsApart(kernel.shape, RelativeMotion.NONE))
                {
                    continue;
                }
                if (!isWayOutMeasured)
                {
                    isWayOutMeasured = true;
                    _lowestOnWayOut.find(_wayOut, kernel.shape);
                }
                if (!_lowestOnWayOut.isAbove(corners, kernel.shape) && kernel.areTouching())
                {
                    return true;
                }
            }
            return false;
        }
    }
}
