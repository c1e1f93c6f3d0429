package starlogo.convex
{
    import flash.geom.Vector3D;

    /**
     * The point of a simplex that is nearest to the origin, as a record.
     *
     * @private
     */
    public final class NearestPoint
    {
        /** The point, and its squared distance: Infinity if there is none. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;
        public var squaredDistance:Number = 0;

        /** The direction from the origin to the point, of any length. It may be more precise than the point itself. */
        public var direction:Vector3D = new Vector3D();

        /** The barycentric coordinates of the point: a weight for each corner of the simplex. Their sum is 1. */
        public var weights:Vector.<Number> = new Vector.<Number>(4, true);

        /** Sets all weights to 0. */
        public function clearWeights():void
        {
            weights[0] = weights[1] = weights[2] = weights[3] = 0;
        }
    }
}
