package starlogo.blocks
{
    import starlogo.agents.Agent;
    import starlogo.data.keyOf;
    import starlogo.data.requireGiven;
    import starlogo.debug.CollisionLines;
    import starlogo.handlers.warnOfMissingBreeds;

    /**
     * The block "show bounding structures". It says which agents' structures are shown, and returns lines to draw: the shapes that the
     * collision system in use tests. They are appended to <code>out</code>: set its length to 0 before each frame. Other calls of the engine overwrite
     * theirs.
     */
    public class StructureBlocks
    {
        private var _collisions:CollisionBlocks;

        // Has the ids of agents and the keys of breeds that are shown. Agents that have left the game can be garbage-collected.
        private var _shown:Object = {};
        private var _lines:CollisionLines;

        /**
         * Shows no structures at first.
         *
         * @param collisions has the agents and the collision system in use
         * @throws ArgumentError if it is null
         */
        public function StructureBlocks(collisions:CollisionBlocks)
        {
            requireGiven("collisions", collisions);
            _collisions = collisions;
            _lines = new CollisionLines(collisions.greatLand);
        }

        /**
         * The block "show bounding structures". A breed need not have agents yet. One that is probably misspelled is warned of.
         *
         * @param subject an agent, or the name of a breed
         * @param isOn whether to show or hide the structures
         * @throws BlockError if the subject is neither
         */
        public function show(subject:Object, isOn:Boolean):void
        {
            BlockChecks.requireTraitSubject("show bounding structures", subject);
            var key:String = subject is Agent ? String(Agent(subject).id) : keyOf(subject as String);
            delete _shown[key];
            if (isOn)
            {
                _shown[key] = true;
            }
            if (subject is String)
            {
                warnOfMissingBreeds(new <String>[subject as String], _collisions.agents, null);
            }
        }

        /** Hides all structures. */
        public function showNone():void
        {
            _shown = {};
        }

        /**
         * Whether an agent's structures are shown, because of the agent itself or its breed.
         *
         * @throws ArgumentError if the agent is null
         */
        public function isShown(agent:Agent):Boolean
        {
            requireGiven("agent", agent);
            return agent.id in _shown || keyOf(agent.breed) in _shown;
        }

        /**
         * The lines of everything that is shown, in world coordinates. A line is six numbers: x, y and z of one end, then of the other.
         *
         * @param out the lines are appended to it; created if null
         * @return out
         */
        public function lines(out:Vector.<Number> = null):Vector.<Number>
        {
            var all:Vector.<Number> = out || new Vector.<Number>();
            for each (var agent:Agent in _collisions.agents)
            {
                if (isShown(agent))
                {
                    linesOf(agent, all);
                }
            }
            return all;
        }

        /**
         * The lines of the shape that the collision system tests for an agent, whether it is shown or not. For a hierarchy, the lines are
         * the level at which the collider stops. In exact mode they are the triangles. While the agent's model is loading, there are none.
         *
         * @param agent an agent of the game
         * @param out the lines are appended to it; created if null
         * @return out, in world coordinates as in <code>lines()</code>
         * @throws ArgumentError if the collision system needs data of the agent's model that was not loaded
         */
        public function linesOf(agent:Agent, out:Vector.<Number> = null):Vector.<Number>
        {
            return _lines.linesOf(agent, _collisions.collision.collisionSystem, out);
        }
    }
}
