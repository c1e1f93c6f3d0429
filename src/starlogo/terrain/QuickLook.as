package starlogo.terrain
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Answers for most agents in a tenth of the time whether they touch the ground. It decides about agents whose inner ball reaches down to
     * the ground, and about agents that are higher above the ground than the steepest slope near them allows.
     *
     * @private
     */
    public final class QuickLook
    {
        /** By place in the list of near members: whether the member is known to touch the ground. */
        public var isTouching:Vector.<Boolean> = new Vector.<Boolean>();

        private var _grid:HeightGrid;

        // By place in the list of members: how high the ground is.
        private var _heights:Vector.<Number> = new Vector.<Number>();

        // The gap across which agents may still touch, because of rounding.
        private var _gap:Number = 0;

        /**
         * Removes members from a list that are known not to touch the ground. Nothing is known about trees, and about agents whose middle is
         * outside of the terrain.
         *
         * @param extents of the agents, by row
         * @param forms of the agents, by row
         * @param rows the row of each member
         * @param members the list; the near ones are moved to its beginning
         * @param count its length
         * @return the number of near members
         */
        public function keepNear(grid:HeightGrid, extents:Extents, forms:Vector.<int>, rows:Vector.<int>, members:Vector.<int>, count:int):int
        {
            var whole:int = grid.bounds.length - 3;
            var slope:Number = grid.isBlocky ? Infinity : grid.bounds[int(whole + 2)] / grid.cellWidth;
            var gap:Number = Tolerances.ROUNDING * (Math.abs(grid.x) + Math.abs(grid.y) + (grid.columns + grid.rows) * grid.cellWidth + Math.abs(grid.bounds[whole])
                    + Math.abs(grid.bounds[int(whole + 1)]));
            var zs:Vector.<Number> = extents.z;
            var halfXs:Vector.<Number> = extents.halfX;
            var heights:Vector.<Number> = _heights;
            var kept:int = 0;
            _grid = grid;
            _gap = gap;
            grid.findHeights(extents.x, extents.y, rows, members, count, heights);
            for (var i:int = 0; i < count; i++)
            {
                var member:int = members[i];
                var row:int = rows[member];
                var isSphere:Boolean = forms[row] == BoundingStructure.SPHERE;
                var above:Number = zs[row] - heights[i];
                var inner:Number = isSphere ? halfXs[row] : 0;
                // Nodes of a tree may extend beyond the tree's extents.
                var isStructure:Boolean = forms[row] <= BoundingStructure.BOX;
                var isKnown:Boolean = above <= inner && isStructure;
                if (above > inner && isStructure)
                {
                    var reach:Number = isSphere ? inner + inner * slope * slope : extents.halfZ[row] + slope * (halfXs[row] + extents.halfY[row]);
                    if (above > reach * Tolerances.OUTER + gap || isFar(extents, row, i, isSphere))
                    {
                        continue;
                    }
                    isKnown = isSphere && isBallBelow(extents, row);
                }
                isTouching[kept] = isKnown;
                members[kept] = member;
                kept++;
            }
            return kept;
        }

        // Whether an agent, by its row and its place in the list, is above all heights near it, or higher than the slopes between them allow.
        // Few heights are read.
        private function isFar(extents:Extents, row:int, at:int, isSphere:Boolean):Boolean
        {
            var grid:HeightGrid = _grid;
            var width:Number = grid.cellWidth;
            var halfX:Number = extents.halfX[row] * Tolerances.OUTER + _gap;
            var halfY:Number = extents.halfY[row] * Tolerances.OUTER + _gap;
            var halfZ:Number = extents.halfZ[row] * Tolerances.OUTER + _gap;
            grid.placeX = extents.x[row];
            grid.placeY = extents.y[row];
            grid.reachX = halfX;
            grid.reachY = halfY;
            grid.findAround();
            if (extents.z[row] - halfZ > grid.greatest)
            {
                return true;
            }
            var riseX:Number = grid.stepX * halfX / width;
            var riseY:Number = grid.stepY * halfY / width;
            var reach:Number = isSphere ? Math.sqrt(halfZ * halfZ + riseX * riseX + riseY * riseY) : halfZ + riseX + riseY;
            return !grid.isBlocky && extents.z[row] - _heights[at] > reach;
        }

        // Whether the ground reaches up to the point of a sphere that is nearest to the plane under its middle.
        private function isBallBelow(extents:Extents, row:int):Boolean
        {
            var grid:HeightGrid = _grid;
            var width:Number = grid.cellWidth;
            grid.placeX = extents.x[row];
            grid.placeY = extents.y[row];
            grid.findHeight();
            grid.findFall();
            var step:Number = extents.halfX[row] / Math.sqrt(grid.fallX * grid.fallX + grid.fallY * grid.fallY + width * width);
            grid.placeX -= step * grid.fallX;
            grid.placeY -= step * grid.fallY;
            grid.findHeight();
            return grid.height >= extents.z[row] - step * width;
        }
    }
}
