package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.convex.FaceNormal;

    /**
     * Whether a point is over a triangle or behind it: its foot on the triangle's plane is in the triangle. False if the normal or the point is NaN.
     *
     * @param p has the triangle: nine numbers, from an index on
     * @param face has the triangle's normal
     * @private
     */
    public function isOverTriangle(point:Vector3D, p:Vector.<Number>, at:int, face:FaceNormal):Boolean
    {
        var from:int = at + 6;
        for (var to:int = at; to < at + 9; to += 3)
        {
            var ux:Number = p[to] - p[from];
            var uy:Number = p[int(to + 1)] - p[int(from + 1)];
            var uz:Number = p[int(to + 2)] - p[int(from + 2)];
            var vx:Number = point.x - p[from];
            var vy:Number = point.y - p[int(from + 1)];
            var vz:Number = point.z - p[int(from + 2)];
            if (!(face.x * (uy * vz - uz * vy) + face.y * (uz * vx - ux * vz) + face.z * (ux * vy - uy * vx) >= 0))
            {
                return false;
            }
            from = to;
        }
        return true;
    }
}
