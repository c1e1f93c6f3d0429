package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.Interval;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /** Rules out squares of the ground that the shape of a GroundSearch clearly does not come near. */
    internal final class SquareSeparation
    {
        // The direction along which the two are apart, from the square to the shape; and how far the shape's core extends along it.
        private var _direction:Vector3D = new Vector3D();
        private var _ofShape:Interval = new Interval();

        private var _place:Vector3D = new Vector3D();

        /**
         * Whether the shape, with its margin, stays farther away from an axis-aligned box around a square than the search's
         * <code>maxDistance</code>. Their distance along one direction decides: it is exact for spheres, and a close lower bound for capsules and
         * boxes.
         *
         * @param search has the shape, and its motion
         * @param square the box around the square
         */
        public function isBeyondMaxDistance(search:GroundSearch, square:GroundBox):Boolean
        {
            var shape:ConvexShape = search.shape;
            var direction:Vector3D = _direction;
            findDirection(shape, square);
            if (!(direction.normalize() > 0))
            {
                return false;
            }
            shape.project(direction, _ofShape);
            var distance:Number = direction.x * (shape.origin.x - square.x) + direction.y * (shape.origin.y - square.y) + direction.z * (shape.origin.z - square.z)
                + _ofShape.min - (shape.radius + shape.margin) * Tolerances.OUTER - Tolerances.EXTENTS * shape.boundingRadius
                - Math.abs(direction.x) * square.halfX - Math.abs(direction.y) * square.halfY - Math.abs(direction.z) * square.halfZ;
            var motion:RelativeMotion = search.motion;
            var travel:Number = motion.latestTime * (direction.x * motion.x + direction.y * motion.y + direction.z * motion.z);
            return distance + Math.min(0, travel) > search.maxDistance;
        }

        // Finds a direction along which the two may be apart. It is between points of both that are near each other.
        private function findDirection(shape:ConvexShape, square:GroundBox):void
        {
            var direction:Vector3D = _direction;
            _place.setTo(square.x, square.y, square.z);
            findNear(shape, _place, direction);
            _place.setTo(nearIn(square.x, square.halfX, direction.x), nearIn(square.y, square.halfY, direction.y), nearIn(square.z, square.halfZ, direction.z));
            findNear(shape, _place, direction);
            direction.decrementBy(_place);
        }

        // The number of an interval that is nearest to another one. The interval has a middle and half a length.
        private static function nearIn(middle:Number, half:Number, to:Number):Number
        {
            return Math.max(middle - half, Math.min(middle + half, to));
        }

        // Finds the point of a core that is nearest to a place. For a hull it is the centre instead. The edges of a box are perpendicular, so each gives
        // its part of the way from their common corner.
        private static function findNear(shape:ConvexShape, place:Vector3D, out:Vector3D):void
        {
            out.copyFrom(shape.origin);
            if (!shape.areEdgesPerpendicular)
            {
                return;
            }
            var p:Vector.<Number> = shape.points;
            var edges:Vector.<int> = shape.edges;
            var x:Number = place.x - (shape.origin.x + p[0]);
            var y:Number = place.y - (shape.origin.y + p[1]);
            var z:Number = place.z - (shape.origin.z + p[2]);
            out.x += p[0];
            out.y += p[1];
            out.z += p[2];
            for (var i:int = 1; i < edges.length; i += 4)
            {
                var to:int = edges[i];
                var ux:Number = p[to] - p[0];
                var uy:Number = p[int(to + 1)] - p[1];
                var uz:Number = p[int(to + 2)] - p[2];
                // NaN for an edge of no length
                var fraction:Number = (x * ux + y * uy + z * uz) / (ux * ux + uy * uy + uz * uz);
                fraction = fraction > 0 ? (fraction < 1 ? fraction : 1) : 0;
                out.x += fraction * ux;
                out.y += fraction * uy;
                out.z += fraction * uz;
            }
        }
    }
}
