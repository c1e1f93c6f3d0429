package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.agents.PlatformLink;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.geometry.copyVector;
    import starlogo.queries.motion.Walk;
    import starlogo.queries.motion.WalkMover;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Moves an agent as a game character walks: reads what the options mean for it, lets the WalkMover go, and says on what it stands.
     *
     * @private
     */
    public final class WalkQueries
    {
        // Ground as steep as the limit is not too steep, although its normal has rounding errors. A fraction of the limit's cosine.
        private static const SLOPE_ROUNDING:Number = 1e-9;

        // A leg of a walk is as long as the agent, or longer if the walk would have more legs than this.
        private static const MOST_LEGS:int = 64;

        private static const UP:Vector3D = new Vector3D(0, 0, 1);

        private static const DEFAULTS:WalkOptions = new WalkOptions();

        private var _seen:SeenAgents;
        private var _walkMover:WalkMover;

        // The walk of a question.
        private var _walks:PerQuestion;

        /** @param seen the agents that the questions are about */
        public function WalkQueries(seen:SeenAgents)
        {
            _seen = seen;
            _walkMover = new WalkMover(seen);
            _walks = new PerQuestion(seen, Walk);
        }

        /** See AgentMotions.walk. */
        public function walk(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Footing):Footing
        {
            _seen.requireMovable(agent, "walk");
            var walk:Walk = findWalk(agent, dx, dy, options || DEFAULTS);
            // before the footing is written, because an agent that would leave the world throws an error
            _seen.moveAgent(agent, walk.place, walk.carryTurn);
            var footing:Footing = out || new Footing();
            footing.copyFrom(walk.footing);
            var link:PlatformLink = agent.platformLink;
            link.platform = null;
            if (footing.stands && walk.floorRow >= ListedAgents.FIRST_LISTED)
            {
                link.setTo(footing.on, _seen.table.bodyOf(walk.floorRow).placement, _seen.table.revisions[walk.floorRow]);
            }
            return footing;
        }

        /**
         * Finds the footing that a walk without a way would give the agent now. Nothing moves, but an agent that has never walked gets an empty
         * PlatformLink. It may be asked in a filter's <code>accepts</code>.
         */
        public function findFooting(agent:Agent, options:WalkOptions, out:Footing):Footing
        {
            out.copyFrom(findWalk(agent, 0, 0, options).footing);
            return out;
        }

        // Finds where a walk leads, and on what the agent stands there. Nothing moves. An agent without a PlatformLink gets an empty one.
        private function findWalk(agent:Agent, dx:Number, dy:Number, options:WalkOptions):Walk
        {
            var walk:Walk = Walk(_walks.current);
            readOptions(agent, dx, dy, options, walk);
            agent.platformLink ||= new PlatformLink(agent);
            var footing:Footing = walk.footing;
            footing.stands = _walkMover.go(agent.platformLink, walk);
            footing.on = footing.stands ? _seen.table.list.agentsByRow[walk.floorRow] : null;
            copyVector(footing.stands ? walk.floorNormal : UP, footing.normal);
            return walk;
        }

        // Finds what the motion and the options mean for the agent.
        private function readOptions(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Walk):void
        {
            var size:Number = _seen.placementOf(agent).size;
            requireMotion(dx, dy, 0, agent);
            var length:Number = Math.sqrt(dx * dx + dy * dy);
            out.options = options;
            out.walkableZ = (1 - SLOPE_ROUNDING) * Trigonometry.cosine(options.slopeDegrees);
            out.legCount = Math.min(MOST_LEGS, Math.max(1, Math.ceil(length / size)));
            out.legMotion.setTo(dx / out.legCount, dy / out.legCount, 0);
            out.legLength = length / out.legCount;
        }
    }
}
