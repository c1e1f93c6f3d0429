package starlogo.geometry
{
    /**
     * The rule of touching: how far apart two shapes may be that touch, because the coordinates of their places are rounded. It holds in every
     * collision system, for agents that stand, that sweep, and for questions about two agents. For the rounding of the sizes of shapes there
     * are Tolerances.TOUCHING, SURFACES and NESTING.
     *
     * <p>Where V8 would make objects of the Numbers that are passed, ShapeStrategy.areSpheresTouching, AgentTable.place and RowDistances write it out to the last
     * bit; Mover and ExtentsTree make margins of it, which are wider.</p>
     *
     * @param aX where one agent is, in patches
     * @param aY likewise
     * @param aZ likewise
     * @param bX where the other is
     * @param bY likewise
     * @param bZ likewise
     * @return a length, Tolerances.PLACES of the coordinates
     *
     * @private
     */
    public function touchingGap(aX:Number, aY:Number, aZ:Number, bX:Number, bY:Number, bZ:Number):Number
    {
        aX = aX < 0 ? -aX : aX;
        aY = aY < 0 ? -aY : aY;
        aZ = aZ < 0 ? -aZ : aZ;
        bX = bX < 0 ? -bX : bX;
        bY = bY < 0 ? -bY : bY;
        bZ = bZ < 0 ? -bZ : bZ;
        return Tolerances.PLACES * (aX + aY + aZ + (bX + bY + bZ));
    }
}
