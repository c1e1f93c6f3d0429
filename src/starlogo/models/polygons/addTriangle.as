package starlogo.models.polygons
{
    /**
     * Adds a triangle of three different vertices to others.
     *
     * @private
     */
    public function addTriangle(triangles:Vector.<uint>, a:uint, b:uint, c:uint):void
    {
        if (a != b && b != c && c != a)
        {
            triangles.push(a, b, c);
        }
    }
}
