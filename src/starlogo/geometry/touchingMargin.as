package starlogo.geometry
{
    /**
     * The rule of touching: how far what stands at a place is wider than it is, because its coordinates are rounded. Two shapes touch if
     * they overlap or touch when both are as much wider, in every collision system, standing, swept and asked. What rounding takes from
     * the sizes of shapes is Tolerances.TOUCHING, SURFACES and NESTING.
     *
     * @param x where an agent is, in patches
     * @param y likewise
     * @param z likewise
     * @return a length, Tolerances.PLACES of the coordinates
     *
     * @private
     */
    public function touchingMargin(x:Number, y:Number, z:Number):Number
    {
        x = x < 0 ? -x : x;
        y = y < 0 ? -y : y;
        z = z < 0 ? -z : z;
        return Tolerances.PLACES * (x + y + z);
    }
}
