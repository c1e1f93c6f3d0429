package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.data.requireGiven;
    import starlogo.geometry.requireInWorld;

    /**
     * Throws an error unless a point is in the world.
     *
     * @private
     */
    public function requirePoint(point:Vector3D):void
    {
        requireGiven("point", point);
        requireInWorld("a point", point.x, point.y, point.z);
    }
}
