package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.terrain.HeightGrid;
    import starlogo.terrain.TerrainAgent;
    import starlogo.terrain.TerrainPair;

    use namespace engine;

    /**
     * Tests two rows of which one is the ground, in either order: whether they touch, when they touch, and how.
     *
     * @private
     */
    public final class GroundPairs
    {
        private var _pairs:RowPairs;
        private var _pair:TerrainPair;
        private var _placement:Placement = new Placement();
        private var _turned:RelativeMotion = new RelativeMotion();

        /** @param pairs knows how deep trees are visited */
        public function GroundPairs(pairs:RowPairs)
        {
            _pairs = pairs;
        }

        /** See RowPairs.areTouching. */
        public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            var isTurned:Boolean = table.forms[a] == ModelShape.GROUND;
            var row:int = isTurned ? b : a;
            var ground:int = isTurned ? a : b;
            var grid:HeightGrid = TerrainAgent(table.agents[ground]).terrain.grid;
            if (table.sizes[ground] == 1 && isSure(table, row, grid))
            {
                return grid.look.isTouching;
            }
            if (table.forms[row] <= BoundingStructure.BOX)
            {
                _pair = grid.pair;
                _pair.inset = (1 - table.sizes[ground]) * grid.cellWidth / 2;
                _pair.gap = Tolerances.PLACES * (Math.abs(table.x[row]) + Math.abs(table.y[row]) + Math.abs(table.z[row]));
                return _pair.isOverlapping(grid, table.structureOf(row), table.extents, row);
            }
            setTo(table, row, ground);
            return _pair.areOverlapping();
        }

        /** See RowPairs.findTime. */
        public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            var own:RelativeMotion = begin(table, a, b, motion);
            _pair.findTime(own);
            motion.time = own.time;
        }

        /** See RowPairs.findContact. */
        public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            var own:RelativeMotion = begin(table, a, b, motion);
            _pair.findContact(own, out);
            if (own !== motion)
            {
                out.turn(motion);
            }
        }

        /** See RowPairs.findImpact. */
        public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            var own:RelativeMotion = begin(table, a, b, motion);
            _pair.findImpact(own, out);
            motion.time = own.time;
            if (own !== motion && out != null && motion.time != RelativeMotion.NEVER)
            {
                out.turn(motion);
            }
        }

        /** See RowPairs.findOuterContact. */
        public function findOuterContact(table:AgentTable, a:int, b:int, out:ContactPoint):void
        {
            var own:RelativeMotion = begin(table, a, b, RelativeMotion.NONE);
            _pair.findOuterContact(out);
            if (own !== RelativeMotion.NONE)
            {
                out.turn(RelativeMotion.NONE);
            }
        }

        /** See TreePairs.findClosest. One of the two rows is the ground. */
        public function findClosest(table:AgentTable, a:int, b:int, areTouching:Boolean, out:ClosestPair):void
        {
            setTo(table, a, b);
            _pair.findClosest(areTouching, out);
        }

        private static function isSure(table:AgentTable, row:int, grid:HeightGrid):Boolean
        {
            var form:int = table.forms[row];
            grid.look.gap = 4 * Tolerances.PLACES * (Math.abs(table.x[row]) + Math.abs(table.y[row]) + Math.abs(table.z[row]));
            return grid.look.decide(grid, table.extents, row, form == BoundingStructure.SPHERE, form != ModelShape.TREE);
        }

        // Sets the pair, and returns the motion of the row that is not the ground.
        private function begin(table:AgentTable, a:int, b:int, motion:RelativeMotion):RelativeMotion
        {
            if (table.forms[a] != ModelShape.GROUND)
            {
                setTo(table, a, b);
                return motion;
            }
            setTo(table, b, a);
            _turned.turn(motion);
            return _turned;
        }

        private function setTo(table:AgentTable, row:int, ground:int):void
        {
            var shape:ModelShape = table.shapes[row];
            var grid:HeightGrid = TerrainAgent(table.agents[ground]).terrain.grid;
            var trees:TreePairs = _pairs.trees;
            // if the ground is made narrower, its size in the table is smaller
            _pair = grid.pair;
            _pair.inset = (1 - table.sizes[ground]) * grid.cellWidth / 2;
            _pair.setTo(grid, shape.hierarchy, shape.structure, table.placementOf(row, _placement), shape.hierarchy == null ? 1 : trees.depthOf(table, row),
                    trees != null && trees.exact);
        }
    }
}
