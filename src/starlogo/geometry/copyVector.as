package starlogo.geometry
{
    import flash.geom.Vector3D;

    /**
     * Copies x, y and z of a vector into one that a game has given. In JavaScript that may be any object with these three, so it has no methods.
     *
     * @private
     */
    public function copyVector(from:Vector3D, out:Vector3D):void
    {
        out.x = from.x;
        out.y = from.y;
        out.z = from.z;
    }
}
