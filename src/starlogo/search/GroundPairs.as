package starlogo.search
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.terrain.FixtureAgent;
    import starlogo.terrain.HeightGrid;
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

        // A list with one member.
        private var _row:Vector.<int> = new Vector.<int>(1, true);
        private var _member:Vector.<int> = new Vector.<int>(1, true);
        private var _placement:Placement = new Placement();

        /** @param pairs knows how deep trees are visited */
        public function GroundPairs(pairs:RowPairs)
        {
            _pairs = pairs;
        }

        /** @inheritDoc */
        override public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            if (table.sizes[b] != 1)
            {
                return pairOf(table, a, b).areOverlapping();
            }
            _row[0] = a;
            _member[0] = 0;
            return keepMembers(table, _row, _member, 1, b) == 1;
        }

        /** @inheritDoc */
        override public function keepMembers(table:AgentTable, rows:Vector.<int>, members:Vector.<int>, count:int, b:int):int
        {
            var grid:HeightGrid = gridOf(table, b);
            var near:int = grid.look.keepNear(grid, table.extents, table.forms, rows, members, count);
            var kept:int = 0;
            for (var i:int = 0; i < near; i++)
            {
                if (grid.look.isTouching[i] || pairOf(table, rows[members[i]], b).areOverlapping())
                {
                    members[kept] = members[i];
                    kept++;
                }
            }
            return kept;
        }

        /** @inheritDoc */
        override public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            pairOf(table, a, b).findTime(motion);
        }

        /** @inheritDoc */
        override public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            var pair:TerrainPair = pairOf(table, a, b);
            pair.findContact(motion, out);
            needed = pair.needed;
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
        override public function findWay(table:AgentTable, a:int, b:int, isFirst:Boolean, most:Number, out:ContactPoint):Boolean
        {
            return pairOf(table, a, b).findWay(isFirst, most, out);
        }

        /** @inheritDoc */
        override public function findClosest(table:AgentTable, a:int, b:int, areTouching:Boolean, out:ClosestPair):void
        {
            pairOf(table, a, b).findClosest(areTouching, out);
        }

        private static function gridOf(table:AgentTable, ground:int):HeightGrid
        {
            var fixture:FixtureAgent = FixtureAgent(table.agents[ground]);
            return fixture.terrain.grid;
        }

        // The test of the ground, set to a row. If the ground is made narrower, its size in the table is smaller.
        private function pairOf(table:AgentTable, a:int, b:int):TerrainPair
        {
            var shape:ModelShape = table.shapes[a];
            var grid:HeightGrid = gridOf(table, b);
            var trees:TreePairs = _pairs.trees;
            var pair:TerrainPair = grid.pair;
            var inset:Number = (1 - table.sizes[b]) * grid.cellWidth / 2;
            var depth:int = shape.hierarchy == null ? 1 : trees.depthOf(table, a);
            pair.setTo(grid, inset, shape.hierarchy, shape.structure, table.placementOf(a, _placement), depth, trees != null && trees.exact);
            return pair;
        }
    }
}
