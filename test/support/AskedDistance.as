package support
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.search.Body;
    import starlogo.search.NarrowPhase;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /** Asks for the distance of two agents as they are now, as a collider sees them. */
    public final class AskedDistance
    {
        /** What was found last. */
        public var closest:ClosestPoints = new ClosestPoints();

        /** Whether the two touch. */
        public var areTouching:Boolean;

        private var _pairs:NarrowPhase;
        private var _table:AgentTable;
        private var _bodyA:Body = new Body();
        private var _bodyB:Body = new Body();

        /** As a collider of these settings sees agents. */
        public function AskedDistance(pairs:NarrowPhase)
        {
            _pairs = pairs;
            _table = new AgentTable(pairs.shapeChoice);
        }

        /** How far two agents are apart. */
        public function between(a:Agent, b:Agent):Number
        {
            _table.currentBodyOf(a, _bodyA);
            _table.currentBodyOf(b, _bodyB);
            areTouching = _pairs.areTouching(_bodyA, _bodyB);
            _pairs.findClosest(_bodyA, _bodyB, true, closest);
            return closest.distance;
        }

        /** The first one's point. */
        public function get pointA():Vector3D
        {
            return closest.a.clone();
        }

        /** The second one's point. */
        public function get pointB():Vector3D
        {
            return closest.b.clone();
        }
    }
}
