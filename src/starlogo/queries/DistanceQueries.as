package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collider;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.geometry.copyVector;
    import starlogo.search.Body;
    import starlogo.search.StructureBody;

    use namespace engine;

    /**
     * Finds the distance between two agents, as a collider sees them. It is 0 if the collider's own test says that they touch, and greater
     * otherwise. Shapes are wider by the margin for the rounding of places (Tolerances.PLACES), as they are in tests for touching.
     *
     * @private
     */
    public final class DistanceQueries
    {
        private var _seen:SeenAgents;
        private var _closest:ClosestPoints = new ClosestPoints();

        // The second body: an agent's, or that of a point.
        private var _body:Body = new Body();
        private var _pointBody:StructureBody = new StructureBody();
        private var _point:Sphere = new Sphere(new Vector3D(), 0);

        /** @param seen the agents that the questions are about */
        public function DistanceQueries(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * The distance between two agents. See AgentQueries.distance.
         *
         * @param pointA receives the first agent's nearest point; or null
         * @param pointB receives the second agent's nearest point; or null
         */
        public function distance(a:Agent, b:Agent, pointA:Vector3D, pointB:Vector3D):Number
        {
            Collider.requireTwo(a, b);
            // a handler may have changed the ground
            _seen.table.refreshWorld();
            if (a.isOfWorld && b.isOfWorld)
            {
                throw new ArgumentError("the ground and the edges of the world have no distance from each other");
            }
            var rowB:int = _seen.rowOf(b);
            if (rowB >= 0 && _seen.table.shapes[rowB] == null)
            {
                return Infinity;
            }
            return measure(_seen.bodyOf(a), rowB < 0 ? _seen.bodyOf(b, _body) : _seen.table.bodyOf(rowB), pointA, pointB);
        }

        /** The distance between an agent and a point. See AgentQueries.distanceToPoint. */
        public function distanceToPoint(agent:Agent, point:Vector3D, out:Vector3D):Number
        {
            requirePoint(point);
            _point.center.setTo(point.x, point.y, point.z);
            var distance:Number = measure(_seen.bodyOf(agent), _pointBody.read(_point), out, null);
            if (distance == 0)
            {
                // without the rounding of that point, which stands in the game's point if that is out too
                copyTo(out, _point.center);
            }
            return distance;
        }

        private function measure(a:Body, b:Body, pointA:Vector3D, pointB:Vector3D):Number
        {
            if (a.shape == null || b.shape == null)
            {
                return Infinity;
            }
            _seen.narrowPhase.findClosest(a, b, pointA != null || pointB != null, _closest);
            if (_closest.distance == Infinity)
            {
                // the edges of a world without edges have no points
                return Infinity;
            }
            copyTo(pointA, _closest.a);
            copyTo(pointB, _closest.b);
            return _closest.distance;
        }

        private static function copyTo(out:Vector3D, point:Vector3D):void
        {
            if (out != null)
            {
                copyVector(point, out);
            }
        }
    }
}
