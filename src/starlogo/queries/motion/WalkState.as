package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.geometry.copyVector;
    import starlogo.queries.Footing;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.WalkOptions;

    /**
     * A walk, as a record: what the options mean for this agent, how far it has come, and on what it stands. The WalkPlanner writes it. The
     * FloorFinder writes the place and the floor where the agent can stand.
     *
     * @private
     */
    public final class WalkState
    {
        private static const UP:Vector3D = new Vector3D(0, 0, 1);

        /** The options of the walk, a copy: a filter's <code>accepts</code> may change those of the game. */
        public var options:WalkOptions = new WalkOptions();

        /** The body of the agent, and the rows near the walk. */
        public var body:MovingBody;

        /** The number of substeps. A walk that is longer than the agent goes in substeps of its size, because the ground may be even only so far. */
        public var substepCount:int = 1;

        /** The motion of a substep on the ground plane, and its length. */
        public var substepMotion:Vector3D = new Vector3D();
        public var substepLength:Number = 0;

        /** The least z of the normal of a surface that is not too steep to stand on. */
        public var minFloorNormalZ:Number = 1;

        /** The agent stands on what is at most this far below it. */
        public var maxFloorDistance:Number = 0;

        /** The row of the platform that carries the agent; -1 if none does. */
        public var platformRow:int = -1;

        /** The motion with which the platform carries the agent, and the turn in degrees. Both are 0 without a platform. */
        public var carry:Vector3D = new Vector3D();
        public var carryTurn:Number = 0;

        /** Where the present substep begins. */
        public var substepStart:Vector3D = new Vector3D();

        /** Where the agent is now. */
        public var place:Vector3D = new Vector3D();

        /** The row that the agent stands on, and the normal of its surface there. The row is -1 if it does not stand. */
        public var floorRow:int = -1;
        public var floorNormal:Vector3D = new Vector3D();

        /** The row of the last wall that the agent met and did not step over; -1 if it met none. */
        public var wallRow:int = -1;

        /** How far the agent was pushed, and the part of its way that it has come. See Footing. */
        public var pushed:Number = 0;
        public var part:Number = 1;

        /** @param seen the agents that the walk is among */
        public function WalkState(seen:SeenAgents)
        {
            body = new MovingBody(seen);
        }

        /** Whether the agent stands. */
        public function get stands():Boolean
        {
            return floorRow >= 0;
        }

        /** Writes how the agent stands now, with its agents by row. Returns the footing. */
        public function writeFooting(agents:Vector.<Agent>, out:Footing):Footing
        {
            out.stands = stands;
            out.on = stands ? agents[floorRow] : null;
            out.against = wallRow >= 0 ? agents[wallRow] : null;
            out.part = part;
            out.pushed = pushed;
            copyVector(stands ? floorNormal : UP, out.normal);
            return out;
        }
    }
}
