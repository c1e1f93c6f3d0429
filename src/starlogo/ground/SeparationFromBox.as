package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.Zonotope;

    /**
     * Finds a direction along which a structure and an axis-aligned box are apart, and how far. The distance is a lower bound of their distance:
     * exact for spheres, and close to it for capsules and boxes. The results are fields that are read only.
     */
    internal final class SeparationFromBox
    {
        /** How far the two are apart along the direction; less than 0 if no such direction was found. */
        public var distance:Number = 0;

        /** The direction, from the box to the structure. */
        public var direction:Vector3D = new Vector3D();

        private var _core:Zonotope = new Zonotope();
        private var _place:Vector3D = new Vector3D();

        /** Finds the direction and the distance. The box has a least corner and a greatest corner. */
        public function find(structure:BoundingStructure, low:Vector3D, high:Vector3D):void
        {
            _core.setTo(structure, RelativeMotion.NONE);
            _place.setTo((low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2);
            _core.nearestInto(direction, _place);
            _place.setTo(Math.max(low.x, Math.min(high.x, direction.x)), Math.max(low.y, Math.min(high.y, direction.y)), Math.max(low.z, Math.min(high.z, direction.z)));
            _core.nearestInto(direction, _place);
            direction.decrementBy(_place);
            distance = -1;
            if (direction.normalize() > 0)
            {
                _core.measure(direction);
                distance = direction.x * _core.x + direction.y * _core.y + direction.z * _core.z - _core.projectedRadius - _core.radius
                    - Math.max(direction.x * high.x, direction.x * low.x) - Math.max(direction.y * high.y, direction.y * low.y) - Math.max(direction.z * high.z, direction.z * low.z);
            }
        }
    }
}
