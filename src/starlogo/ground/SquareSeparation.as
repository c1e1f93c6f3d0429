package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.Zonotope;

    /** Rules out squares of the ground that the structure in a GroundBox clearly does not come near. */
    internal final class SquareSeparation
    {
        // The direction along which the two are apart, from the square to the structure.
        private var _direction:Vector3D = new Vector3D();

        private var _core:Zonotope = new Zonotope();
        private var _place:Vector3D = new Vector3D();

        /**
         * Whether the structure stays farther away from an axis-aligned box around a square than the GroundBox's <code>maxDistance</code>. Their
         * distance along one direction decides: it is exact for spheres, and a close lower bound for capsules and boxes.
         *
         * @param box has the structure, and its motion
         * @param low the least corner around the square
         * @param high the greatest one
         */
        public function isBeyond(box:GroundBox, low:Vector3D, high:Vector3D):Boolean
        {
            var direction:Vector3D = _direction;
            _core.setTo(box.structure);
            findDirection(low, high);
            if (!(direction.normalize() > 0))
            {
                return false;
            }
            _core.measure(direction);
            var distance:Number = direction.x * _core.x + direction.y * _core.y + direction.z * _core.z - _core.projectedRadius - _core.radius
                - Math.max(direction.x * high.x, direction.x * low.x) - Math.max(direction.y * high.y, direction.y * low.y) - Math.max(direction.z * high.z, direction.z * low.z);
            var motion:RelativeMotion = box.motion;
            var travel:Number = box.latest * (direction.x * motion.x + direction.y * motion.y + direction.z * motion.z);
            return distance + Math.min(0, travel) > box.maxDistance;
        }

        // Finds a direction along which the two may be apart. It is between points of both that are near each other.
        private function findDirection(low:Vector3D, high:Vector3D):void
        {
            var direction:Vector3D = _direction;
            _place.setTo((low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2);
            _core.nearestInto(direction, _place);
            _place.setTo(Math.max(low.x, Math.min(high.x, direction.x)), Math.max(low.y, Math.min(high.y, direction.y)), Math.max(low.z, Math.min(high.z, direction.z)));
            _core.nearestInto(direction, _place);
            direction.decrementBy(_place);
        }
    }
}
