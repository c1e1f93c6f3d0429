package starlogo.convex
{
    import flash.geom.Vector3D;

    /** The point of a simplex that is nearest to the origin, as a record. */
    internal final class NearestPoint
    {
        /** The point, and its squared distance: Infinity if there is none. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;
        public var squaredDistance:Number = 0;

        /** The direction from the origin to the point, of any length. It may be more precise than the point itself. */
        public var direction:Vector3D = new Vector3D();

        /** For each corner of the simplex, its share of the point. */
        public var shares:Vector.<Number> = new Vector.<Number>(4, true);

        /** Sets all shares to 0. */
        public function clearShares():void
        {
            shares[0] = shares[1] = shares[2] = shares[3] = 0;
        }
    }
}
