package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * What is known about the exits from the ground of the deepest point of a contact (<code>ContactPoint.writeDeepestPoint()</code>). Contacts are in
     * the world.
     *
     * @private
     */
    public final class GroundExits
    {
        // A depth is proven if no exit is shorter than this fraction of it. The fraction is larger than the one that PenetrationSearch requires, so a proven depth
        // needs no search for other ways out. Larger: more contacts need one.
        internal static const MIN_RATIO_PROVEN:Number = 0.8;

        private var _deepest:Vector3D = new Vector3D();

        // Bounds of the heights around the deepest point.
        private var _heightsAround:HeightBounds = new HeightBounds();

        /**
         * A lower bound for the lengths of the exits of the deepest point; 0 if none is known. Exits that are longer than <code>maxLength</code> do not
         * count.
         */
        public function boundOf(grid:HeightGrid, contact:ContactPoint, maxLength:Number):Number
        {
            contact.writeDeepestPoint(_deepest);
            var below:Number = grid.heightAt(_deepest.x, _deepest.y) - _deepest.z;
            if (!(below > 0 && distanceToEnd(grid, _deepest) >= maxLength))
            {
                return 0;
            }
            grid.pyramid.findAround(_deepest.x, _deepest.y, maxLength, maxLength, _heightsAround);
            if (_heightsAround.hasHole)
            {
                return 0;
            }
            // all of the ground around is at least as high as its least height, and no slope leads to the point faster than the steepest
            var least:Number = Math.max(0, _heightsAround.min - _deepest.z);
            if (grid.isBlocky)
            {
                return least;
            }
            var slopeX:Number = _heightsAround.maxStepX / grid.cellWidth;
            var slopeY:Number = _heightsAround.maxStepY / grid.cellWidth;
            return Math.max(least, below / Math.sqrt(1 + slopeX * slopeX + slopeY * slopeY));
        }

        /** Whether each exit is at least about as long as a contact is deep, because its deepest point has to get out. */
        internal function isDepthProven(grid:HeightGrid, contact:ContactPoint):Boolean
        {
            return contact.depth >= 0 && boundOf(grid, contact, contact.depth) >= MIN_RATIO_PROVEN * contact.depth;
        }

        // How far a point in the ground is from where the ground ends, along x or y.
        private static function distanceToEnd(grid:HeightGrid, point:Vector3D):Number
        {
            var alongX:Number = Math.min(point.x - grid.x, grid.x + (grid.columns - 1) * grid.cellWidth - point.x);
            var alongY:Number = Math.min(point.y - grid.y, grid.y + (grid.rows - 1) * grid.cellWidth - point.y);
            return Math.min(alongX, alongY) + grid.border;
        }
    }
}
