package starlogo.queries
{
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.distance.findClosest;
    import starlogo.search.AgentTable;
    import starlogo.search.ModelShape;
    import starlogo.search.RowPairs;
    import starlogo.solid.HierarchyDistances;

    use namespace engine;

    /**
     * Finds how far two rows of a table are apart, as a collider sees them: 0 where its pairs say that they touch, more everywhere else. The
     * shapes count as wide as they are for touching (Tolerances.PLACES): by what the rounding of places comes to.
     *
     * @private
     */
    public final class RowDistances
    {
        /** The distance of the rows that were asked about last, and their closest points, in the world. */
        public var closest:ClosestPair = new ClosestPair();

        private var _hierarchies:HierarchyDistances = new HierarchyDistances();
        private var _placementA:Placement = new Placement();
        private var _placementB:Placement = new Placement();

        /** Nothing found yet. */
        public function RowDistances()
        {
        }

        /**
         * Finds how far two rows are apart: <code>closest</code>.
         *
         * @param pairs say whether rows touch
         * @param table has both, with shapes
         * @param withPoints whether the points are needed too
         */
        public function find(pairs:RowPairs, table:AgentTable, a:int, b:int, withPoints:Boolean):void
        {
            if (RowPairs.isSecondFirst(table, a, b))
            {
                measure(pairs, table, b, a, withPoints);
                closest.turn();
            }
            else
            {
                measure(pairs, table, a, b, withPoints);
            }
        }

        private function measure(pairs:RowPairs, table:AgentTable, a:int, b:int, withPoints:Boolean):void
        {
            var shapeA:ModelShape = table.shapes[a];
            var shapeB:ModelShape = table.shapes[b];
            if (shapeA.hierarchy == null)
            {
                findClosest(table.structureOf(a), table.structureOf(b), closest);
                var extents:Extents = table.extents;
                var size:Number = extents.halfX[a] + extents.halfY[a] + extents.halfZ[a] + extents.halfX[b] + extents.halfY[b] + extents.halfZ[b];
                // boxes of which only the faces are tested may touch across a gap
                var isNear:Boolean = pairs.structures.boxFacesOnly || closest.distance <= Tolerances.APART * size;
                closest.settle(isNear && pairs.areTouching(table, a, b));
                return;
            }
            var areTouching:Boolean = pairs.areTouching(table, a, b);
            if (areTouching && !withPoints)
            {
                closest.distance = 0;
                return;
            }
            var placementA:Placement = table.placementOf(a, _placementA);
            var placementB:Placement = table.placementOf(b, _placementB);
            if (shapeB.hierarchy == null)
            {
                _hierarchies.toStructure(shapeA.hierarchy, placementA, pairs.trees.depthOf(table, a), shapeB.structure, placementB, areTouching,
                        closest);
                return;
            }
            _hierarchies.betweenHierarchies(shapeA.hierarchy, placementA, pairs.trees.depthOf(table, a), shapeB.hierarchy, placementB,
                    pairs.trees.depthOf(table, b), pairs.trees.exact, areTouching, closest);
        }
    }
}
