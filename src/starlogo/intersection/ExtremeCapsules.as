package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;

    /** Capsules so long or so short that products of four lengths would overflow or vanish. It allocates, where nobody will ever notice. */
    internal final class ExtremeCapsules
    {
        /**
         * Whether two capsules meet.
         *
         * @param a in the space of b
         * @param b in the space of a
         * @param unit the length of the longer one's segment, in which both are measured
         */
        public static function areClose(a:Capsule, b:Capsule, unit:Number):Boolean
        {
            return capsuleCapsule(inUnits(a, a.start, unit), inUnits(b, a.start, unit));
        }

        private static function inUnits(capsule:Capsule, origin:Vector3D, unit:Number):Capsule
        {
            return new Capsule(between(origin, capsule.start, unit), between(origin, capsule.end, unit), capsule.radius / unit);
        }

        private static function between(origin:Vector3D, point:Vector3D, unit:Number):Vector3D
        {
            return new Vector3D((point.x - origin.x) / unit, (point.y - origin.y) / unit, (point.z - origin.z) / unit);
        }
    }
}
