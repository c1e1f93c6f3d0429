package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.contact.Zonotope;

    /**
     * Finds a direction along which a structure and an axis-aligned box are apart, and how far. The gap is a lower bound of their distance:
     * exact for spheres, and close to it for capsules and boxes. The results are fields that are read only.
     *
     * @private
     */
    public final class GapToBox
    {
        /** How far the two are apart along the direction; less than 0 if no such direction was found. */
        public var gap:Number = 0;

        /** The direction, from the box to the structure. */
        public var along:Vector3D = new Vector3D();

        private var _core:Zonotope = new Zonotope();
        private var _place:Vector3D = new Vector3D();

        /** Finds the direction and the gap. The box has a least corner and a greatest corner. */
        public function find(structure:BoundingStructure, low:Vector3D, high:Vector3D):void
        {
            _core.setTo(structure, RelativeMotion.NONE);
            _place.setTo((low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2);
            _core.nearestInto(along, _place);
            _place.setTo(Math.max(low.x, Math.min(high.x, along.x)), Math.max(low.y, Math.min(high.y, along.y)), Math.max(low.z, Math.min(high.z, along.z)));
            _core.nearestInto(along, _place);
            along.decrementBy(_place);
            gap = -1;
            if (along.normalize() > 0)
            {
                _core.measure(along);
                gap = along.x * _core.x + along.y * _core.y + along.z * _core.z - _core.reach - _core.radius
                    - Math.max(along.x * high.x, along.x * low.x) - Math.max(along.y * high.y, along.y * low.y) - Math.max(along.z * high.z, along.z * low.z);
            }
        }
    }
}
