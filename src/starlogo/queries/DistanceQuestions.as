package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.search.AgentTable;

    use namespace engine;

    /**
     * The question how far two agents are apart.
     *
     * @private
     */
    public final class DistanceQuestions
    {
        /** What was found last. */
        public var closest:ClosestPair;

        private var _seen:SeenAgents;
        private var _rows:RowDistances = new RowDistances();

        /**
         * @param seen the agents that are asked about
         */
        public function DistanceQuestions(seen:SeenAgents)
        {
            _seen = seen;
            closest = _rows.closest;
        }

        /**
         * Finds how far two agents are apart, as AgentQueries.distance says: <code>closest</code>.
         *
         * @param pointA takes the one point; or null
         * @param pointB takes the other
         */
        public function find(a:Agent, b:Agent, pointA:Vector3D, pointB:Vector3D):void
        {
            findRows(a, b, pointA != null || pointB != null);
            if (closest.distance == Infinity)
            {
                return;
            }
            if (pointA != null)
            {
                pointA.x = closest.aX;
                pointA.y = closest.aY;
                pointA.z = closest.aZ;
            }
            if (pointB != null)
            {
                pointB.x = closest.bX;
                pointB.y = closest.bY;
                pointB.z = closest.bZ;
            }
        }

        private function findRows(a:Agent, b:Agent, withPoints:Boolean):void
        {
            if (a == null || b == null || a === b)
            {
                throw new ArgumentError(a == null || b == null ? "two agents are needed, not " + a + " and " + b
                        : "two agents are needed: " + a + " is no pair with itself");
            }
            var table:AgentTable = _seen.table;
            var rowA:int = _seen.rowOfNow(a, 0);
            var rowB:int = table.rowOf(b);
            if (rowB < 0)
            {
                rowB = _seen.rowOfNow(b, 1);
            }
            measure(table, rowA, rowB, withPoints);
            table.endGuests();
        }

        private function measure(table:AgentTable, a:int, b:int, withPoints:Boolean):void
        {
            if (table.shapes[a] == null || table.shapes[b] == null)
            {
                closest.distance = Infinity;
            }
            else
            {
                _rows.find(_seen.pairs, table, a, b, withPoints);
            }
        }
    }
}
