package starlogo.blocks
{
    import starlogo.agents.Agent;
    import starlogo.debug.CollisionLines;
    import starlogo.search.IdTable;

    /** The block "show bounding structures": which agents it shows, and the lines of what the collision system in use tests. */
    public class StructureBlocks
    {
        private var _collisions:CollisionBlocks;
        private var _breeds:Vector.<String> = new Vector.<String>();

        // By the ids of agents, 1 for those that are shown: agents that leave the game are not kept.
        private var _agents:IdTable = new IdTable();
        private var _lines:CollisionLines;

        /**
         * Shows no agent's structures.
         *
         * @param collisions know the agents, and the collision system in use
         * @throws ArgumentError if it is null
         */
        public function StructureBlocks(collisions:CollisionBlocks)
        {
            if (collisions == null)
            {
                throw new ArgumentError("collision blocks are needed, not null");
            }
            _collisions = collisions;
            _lines = new CollisionLines(collisions.greatLand);
        }

        /**
         * The block "show bounding structures".
         *
         * @param subject an agent, or the name of a breed
         * @param isOn whether to show them, or to cease to
         * @throws BlockError if it is neither
         */
        public function show(subject:Object, isOn:Boolean):void
        {
            BlockSubject.check("show bounding structures", subject);
            if (subject is Agent)
            {
                _agents.set (Agent(subject).id, isOn ? 1 : 0);
                return;
            }
            var index:int = _breeds.indexOf(subject as String);
            if (index >= 0)
            {
                _breeds.splice(index, 1);
            }
            if (isOn)
            {
                _breeds.push(subject);
            }
        }

        /** Shows no agent's structures any more. */
        public function showNone():void
        {
            _breeds.length = 0;
            _agents.clear();
        }

        /** Whether an agent's structures are shown, for itself or for its breed. */
        public function isShown(agent:Agent):Boolean
        {
            return _agents.valueOf(agent.id) == 1 || _breeds.indexOf(agent.breed) >= 0;
        }

        /**
         * The lines of all that is shown, in the world: six numbers each, x, y and z of one end, then of the other.
         *
         * @param out the lines are added to it; made if null
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
         * The lines of what the collision system in use tests of an agent, shown or not; none while its model is loading. Of a hierarchy,
         * the level at which the collider stops; in exact mode the triangles, which decide.
         *
         * @param agent one of the game
         * @param out the lines are added to it; made if null
         * @return out, in the world as in <code>lines()</code>
         * @throws ArgumentError if what the collision system needs of the agent's model was not loaded
         */
        public function linesOf(agent:Agent, out:Vector.<Number> = null):Vector.<Number>
        {
            return _lines.linesOf(agent, _collisions.collision.collisionSystem, out);
        }
    }
}
