package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.distance.findClosest;
    import starlogo.search.AgentTable;
    import starlogo.search.HierarchyStrategy;
    import starlogo.search.ModelShape;
    import starlogo.search.ShapeStrategy;
    import starlogo.solid.HierarchyDistances;

    use namespace engine;

    /**
     * Finds how far two rows of a table are apart, as a collider sees them: 0 where its strategy says that they touch, more everywhere else. The
     * shapes count as wide as they are for touching (Tolerances.PLACES): by what the rounding of places comes to.
     *
     * @private
     */
    public final class RowDistances
    {
        /** The distance of the rows that were asked about last, and their closest points, in the world. */
        public var closest:ClosestPair = new ClosestPair();

        private var _hierarchies:HierarchyDistances = new HierarchyDistances();
        private var _sphereA:Sphere = new Sphere(new Vector3D(), 0);
        private var _sphereB:Sphere = new Sphere(new Vector3D(), 0);
        private var _placementA:Placement = new Placement();
        private var _placementB:Placement = new Placement();

        /** Nothing found yet. */
        public function RowDistances()
        {
        }

        /**
         * Finds how far two rows are apart: <code>closest</code>.
         *
         * @param strategy says whether rows touch
         * @param table has both, with shapes
         * @param withPoints whether the points are needed too
         */
        public function find(strategy:ShapeStrategy, table:AgentTable, a:int, b:int, withPoints:Boolean):void
        {
            if (HierarchyStrategy.isSecondFirst(table, a, b))
            {
                measure(strategy, table, b, a, withPoints);
                closest.turn();
            }
            else
            {
                measure(strategy, table, a, b, withPoints);
            }
        }

        private function measure(strategy:ShapeStrategy, table:AgentTable, a:int, b:int, withPoints:Boolean):void
        {
            var shapeA:ModelShape = table.shapes[a];
            var shapeB:ModelShape = table.shapes[b];
            if (shapeA.hierarchy == null)
            {
                findClosest(structureOf(table, a, _sphereA), structureOf(table, b, _sphereB), closest);
                var extents:Extents = table.extents;
                var size:Number = extents.halfX[a] + extents.halfY[a] + extents.halfZ[a] + extents.halfX[b] + extents.halfY[b] + extents.halfZ[b];
                var isNear:Boolean = strategy.touchesAcrossGaps || closest.distance <= Tolerances.APART * size;
                closest.settle(isNear && strategy.areTouching(table, a, b));
                return;
            }
            var areTouching:Boolean = strategy.areTouching(table, a, b);
            if (areTouching && !withPoints)
            {
                closest.distance = 0;
                return;
            }
            var placementA:Placement = table.placementOf(a, _placementA);
            var placementB:Placement = table.placementOf(b, _placementB);
            if (shapeB.hierarchy == null)
            {
                _hierarchies.toStructure(shapeA.hierarchy, placementA, strategy.depthOf(table, a), shapeB.structure, placementB, areTouching,
                        closest);
                return;
            }
            _hierarchies.betweenHierarchies(shapeA.hierarchy, placementA, strategy.depthOf(table, a), shapeB.hierarchy, placementB,
                    strategy.depthOf(table, b), strategy.isExact, areTouching, closest);
        }

        /**
         * The structure of a row that is no hierarchy, in the world, as wide as for touching.
         *
         * @param sphere takes it if it is a sphere
         */
        internal static function structureOf(table:AgentTable, row:int, sphere:Sphere):BoundingStructure
        {
            if (!table.shapes[row].isSphere)
            {
                return table.structureOf(row);
            }
            sphere.center.x = table.extents.x[row];
            sphere.center.y = table.extents.y[row];
            sphere.center.z = table.extents.z[row];
            sphere.radius = table.extents.halfX[row] * Tolerances.TOUCHING
                + Tolerances.PLACES * (Math.abs(table.x[row]) + Math.abs(table.y[row]) + Math.abs(table.z[row]));
            return sphere;
        }
    }
}
