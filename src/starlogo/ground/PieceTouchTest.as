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

        // A place under the piece, and the ground there.
        private var _ground:GroundPoint = new GroundPoint();

        // The direction out of the ground below the piece, and the normal of the contact that was found last; and the piece's lowest points along both.
        private var _directionOut:Vector3D = new Vector3D();
        private var _wayOut:Vector3D = new Vector3D(0, 0, 1);
        private var _lowest:LowestPoint = new LowestPoint(_directionOut);
        private var _lowestOnWayOut:LowestPoint = new LowestPoint(_wayOut);

        /** @param pairs of the model */
        public function PieceTouchTest(pairs:PieceTrianglePairs)
        {
            _pairs = pairs;
        }

        /** Whether the piece touches the ground. Its triangles are those that come next. */
        public function isTouching():Boolean
        {
            if (isUnder(0))
            {
                return true;
            }
            // no triangle is near a node that stands for the pieces below it
            return !_pairs.pieces.isDivisible && (isLowestUnder() || touchesTriangle());
        }

        /** Whether a point of the piece is at least this deep under the ground. */
        public function isUnder(depth:Number):Boolean
        {
            var origin:Placement = _pairs.origin;
            var point:Vector3D = _pairs.pieces.point;
            _ground.x = point.x + origin.x;
            _ground.y = point.y + origin.y;
            _pairs.grid.findHeight(_ground);
            return _ground.height - depth >= point.z + origin.z;
        }

        /** Notes the normal of a contact of the model. It makes later tests quicker, of the model along this way out. No answer depends on it. */
        public function noteWayOut(contact:ContactPoint):void
        {
            _wayOut.x = contact.normalX;
            _wayOut.y = contact.normalY;
            _wayOut.z = contact.normalZ;
        }

        // Whether the lowest point above the slope below the first point is under the ground. Nearly all pieces that reach under the ground do so there.
        private function isLowestUnder():Boolean
        {
            var origin:Placement = _pairs.origin;
            _pairs.grid.findDirectionOut(_ground, _directionOut);
            _lowest.find(_pairs.kernel.shape);
            _ground.x = _lowest.x + origin.x;
            _ground.y = _lowest.y + origin.y;
            _pairs.grid.findHeight(_ground);
            return _ground.height >= _lowest.z + origin.z;
        }

        // Whether the piece touches a triangle near it. A model that is tried along its way out is above nearly all triangles there.
        private function touchesTriangle():Boolean
        {
            var kernel:TriangleKernel = _pairs.kernel;
            var isWayOutMeasured:Boolean = false;
            while (_pairs.nextTriangle())
            {
                var corners:Vector.<Number> = _pairs.triangle.corners;
                if (_lowest.isAbove(corners, kernel.shape) || kernel.planeKeepsApart(RelativeMotion.NONE))
                {
                    continue;
                }
                if (!isWayOutMeasured)
                {
                    isWayOutMeasured = true;
                    _lowestOnWayOut.find(kernel.shape);
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
