package starlogo.ground
{
    /**
     * A lower bound for the lengths of the exits from the ground at a place; 0 if none is known. Exits that are longer than
     * <code>maxLength</code> do not count.
     *
     * @param around receives bounds of the heights near the place
     * @private
     */
    public function leastExit(grid:HeightGrid, x:Number, y:Number, z:Number, maxLength:Number, around:HeightRange):Number
    {
        var high:Number = grid.heightAt(x, y);
        if (!(high > z && grid.distanceToEnd(x, y) >= maxLength))
        {
            return 0;
        }
        grid.pyramid.findAround(x, y, maxLength, maxLength, around);
        if (around.hasHole)
        {
            return 0;
        }
        var least:Number = Math.max(0, around.least - z);
        if (grid.isBlocky)
        {
            return least;
        }
        var slopeX:Number = around.stepX / grid.cellWidth;
        var slopeY:Number = around.stepY / grid.cellWidth;
        return Math.max(least, (high - z) / Math.sqrt(1 + slopeX * slopeX + slopeY * slopeY));
    }
}
