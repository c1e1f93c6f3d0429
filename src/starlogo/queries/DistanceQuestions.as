package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.bounding.Sphere;
    import starlogo.broadphase.Extents;
    import starlogo.collision.Collider;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.distance.findClosest;
    import starlogo.search.AgentTable;
    import starlogo.search.ModelShape;
    import starlogo.search.RowPairs;

    use namespace engine;

    /**
     * Finds the distance between two agents, as a collider sees them. It is 0 if the collider's own test says that they touch, and greater
     * otherwise. Shapes are wider by the margin for the rounding of places (Tolerances.PLACES), as they are in tests for touching.
     *
     * @private
     */
    public final class DistanceQuestions
    {
        /** The last distance, and the closest points in the world. */
        public var closest:ClosestPair = new ClosestPair();

        private var _seen:SeenAgents;
        private var _point:Sphere = new Sphere(new Vector3D(), 0);

        /** @param seen the agents that questions are about */
        public function DistanceQuestions(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Finds the distance between two agents, and writes it to <code>closest</code>. See AgentQueries.distance.
         *
         * @param pointA receives the first agent's nearest point; or null
         * @param pointB receives the second agent's nearest point; or null
         */
        public function find(a:Agent, b:Agent, pointA:Vector3D, pointB:Vector3D):void
        {
            Collider.requireTwo(a, b);
            if (Breeds.isReserved(a.breedNumber) && Breeds.isReserved(b.breedNumber))
            {
                throw new ArgumentError("the ground and the edges of the world have no distance from each other");
            }
            var table:AgentTable = _seen.table;
            var rowA:int = _seen.rowOfNow(a, 0);
            var rowB:int = table.rowOf(b);
            if (rowB < 0)
            {
                rowB = _seen.rowOfNow(b, 1);
            }
            answer(rowA, rowB, pointA, pointB);
        }

        /** Finds the distance between an agent and a point, and writes it to <code>closest</code>. See AgentQueries.distanceToPoint. */
        public function findToPoint(agent:Agent, point:Vector3D, out:Vector3D):void
        {
            _point.center.setTo(point.x, point.y, point.z);
            answer(_seen.rowOfNow(agent, 1), _seen.rowOfEither(null, _point), out, null);
            if (closest.distance == 0)
            {
                // without the rounding of the point that was found
                write(out, point.x, point.y, point.z);
            }
        }

        /**
         * Finds the distance between two rows of a table, and writes it to <code>closest</code>.
         *
         * @param pairs tests whether rows touch
         * @param table has both rows, with their shapes
         * @param withPoints whether the closest points are needed too
         */
        public function measure(pairs:RowPairs, table:AgentTable, a:int, b:int, withPoints:Boolean):void
        {
            if (RowPairs.isSecondFirst(table, a, b))
            {
                measureInOrder(pairs, table, b, a, withPoints);
                closest.turn();
            }
            else
            {
                measureInOrder(pairs, table, a, b, withPoints);
            }
        }

        private function measureInOrder(pairs:RowPairs, table:AgentTable, a:int, b:int, withPoints:Boolean):void
        {
            if (table.shapes[a].hierarchy == null && table.forms[b] < ModelShape.GROUND)
            {
                findClosest(table.structureOf(a), table.structureOf(b), closest);
                var extents:Extents = table.extents;
                var size:Number = extents.halfX[a] + extents.halfY[a] + extents.halfZ[a] + extents.halfX[b] + extents.halfY[b] + extents.halfZ[b];
                // boxes that are tested only by their faces may touch across a gap
                var isNear:Boolean = pairs.structures.settings.boxFacesOnly || closest.distance <= Tolerances.APART * size;
                closest.settle(isNear && pairs.areTouching(table, a, b));
                return;
            }
            var areTouching:Boolean = pairs.areTouching(table, a, b);
            if (areTouching && !withPoints)
            {
                closest.distance = 0;
                return;
            }
            pairs.testsOf(table, a, b).findClosest(table, a, b, areTouching, closest);
        }

        private function answer(rowA:int, rowB:int, pointA:Vector3D, pointB:Vector3D):void
        {
            var table:AgentTable = _seen.table;
            closest.distance = Infinity;
            if (table.shapes[rowA] != null && table.shapes[rowB] != null)
            {
                measure(_seen.pairs, table, rowA, rowB, pointA != null || pointB != null);
                write(pointA, closest.aX, closest.aY, closest.aZ);
                write(pointB, closest.bX, closest.bY, closest.bZ);
            }
            table.endGuests();
        }

        private static function write(out:Vector3D, x:Number, y:Number, z:Number):void
        {
            if (out != null)
            {
                // sets the fields one by one, because JavaScript callers may pass an object that is not a Vector3D
                out.x = x;
                out.y = y;
                out.z = z;
            }
        }
    }
}
