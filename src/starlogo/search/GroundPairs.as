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
    import starlogo.terrain.FixtureAgent;
    import starlogo.terrain.TerrainPair;

    use namespace engine;

    /**
     * Tests a row and the ground, which is the second row of each pair: whether they touch, when they touch, and how.
     *
     * @private
     */
    public final class GroundPairs extends PairTests
    {
        private var _pairs:RowPairs;
        private var _placement:Placement = new Placement();

        /** @param pairs knows how deep trees are visited */
        public function GroundPairs(pairs:RowPairs)
        {
            _pairs = pairs;
        }

        /** @inheritDoc */
        override public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            var ground:FixtureAgent = FixtureAgent(table.agents[b]);
            var grid:HeightGrid = ground.terrain.grid;
            var form:int = table.forms[a];
            grid.look.gap = 4 * Tolerances.PLACES * (Math.abs(table.x[a]) + Math.abs(table.y[a]) + Math.abs(table.z[a]));
            if (table.sizes[b] == 1 && grid.look.decide(grid, table.extents, a, form == BoundingStructure.SPHERE, form != ModelShape.TREE))
            {
                return grid.look.isTouching;
            }
            return pairOf(table, a, b).areOverlapping();
        }

        /** @inheritDoc */
        override public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            pairOf(table, a, b).findTime(motion);
        }

        /** @inheritDoc */
        override public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            pairOf(table, a, b).findContact(motion, out);
        }

        /** @inheritDoc */
        override public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            pairOf(table, a, b).findImpact(motion, out);
        }

        /** @inheritDoc */
        override public function findOuterContact(table:AgentTable, a:int, b:int, out:ContactPoint):void
        {
            pairOf(table, a, b).findOuterContact(out);
        }

        /** @inheritDoc */
        override public function findClosest(table:AgentTable, a:int, b:int, areTouching:Boolean, out:ClosestPair):void
        {
            pairOf(table, a, b).findClosest(areTouching, out);
        }

        // The test of the ground, set to a row. If the ground is made narrower, its size in the table is smaller.
        private function pairOf(table:AgentTable, a:int, b:int):TerrainPair
        {
            var ground:FixtureAgent = FixtureAgent(table.agents[b]);
            var grid:HeightGrid = ground.terrain.grid;
            var shape:ModelShape = table.shapes[a];
            var trees:TreePairs = _pairs.trees;
            var pair:TerrainPair = grid.pair;
            var inset:Number = (1 - table.sizes[b]) * grid.cellWidth / 2;
            var depth:int = shape.hierarchy == null ? 1 : trees.depthOf(table, a);
            pair.setTo(grid, inset, shape.hierarchy, shape.structure, table.placementOf(a, _placement), depth, trees != null && trees.exact);
            return pair;
        }
    }
}
