package starlogo.search
{
    import flash.geom.Vector3D;
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
        private var _farthest:FarthestPoint = new FarthestPoint();
        private var _inwards:Vector3D = new Vector3D();

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
        override public function findWays(table:AgentTable, a:int, b:int, ways:Vector.<ContactPoint>):int
        {
            var count:int = pairOf(table, a, b).findWays(reach, ways);
            if (table.forms[a] == ModelShape.TREE)
            {
                for (var i:int = 0; i < count; i++)
                {
                    measure(table, a, ways[i]);
                }
            }
            return count;
        }

        /** @inheritDoc */
        override public function findClosest(table:AgentTable, a:int, b:int, areTouching:Boolean, out:ClosestPair):void
        {
            pairOf(table, a, b).findClosest(areTouching, out);
        }

        // Changes a contact's depth behind a plane from the depth of the structure around a tree to that of the tree itself.
        private function measure(table:AgentTable, a:int, way:ContactPoint):void
        {
            var plane:Number = way.normalX * way.x + way.normalY * way.y + way.normalZ * way.z + way.depth / 2;
            _inwards.setTo(-way.normalX, -way.normalY, -way.normalZ);
            _farthest.setTo(table, a, _pairs.trees);
            _farthest.find(_inwards);
            way.depth = plane + _farthest.reach;
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
