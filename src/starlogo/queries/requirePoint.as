package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.geometry.requireInWorld;

    /**
     * Throws an error unless a point is in the world.
     *
     * @private
     */
    public function requirePoint(point:Vector3D):void
    {
        if (point == null)
        {
            throw new ArgumentError("a point is needed, not null");
        }
        requireInWorld("a point", point.x, point.y, point.z);
    }
}
