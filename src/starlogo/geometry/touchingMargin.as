package starlogo.geometry
{
    /**
     * The rule of touching: by how much a shape at a place is enlarged, because the coordinates of the place are rounded. Two shapes touch if they
     * overlap or touch when both are enlarged so; this holds in every collision system, for agents that stand, that sweep, and for questions about
     * two agents. For the rounding of the sizes of shapes there are Tolerances.TOUCHING, SURFACES and NESTING.
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
