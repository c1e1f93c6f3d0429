package starlogo.blocks
{
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.handlers.warnOfMissingBreeds;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.ShapeHit;
    import starlogo.terrain.WorldBounds;

    use namespace engine;

    /**
     * The blocks that ask about other agents: "count within", "count with", "nearest within", "nearest with", "touching?", "can see?", "distance
     * to", "ahead", "distance ahead". An answer never contains the agent that asks. That agent counts at its present place. The others count where
     * they were when the frame began, or at the last call of <code>moved()</code>.
     */
    public class DetectionBlocks
    {
        private var _collisions:CollisionBlocks;
        private var _queries:AgentQueries;
        private var _ahead:ShapeHit = new ShapeHit();

        // The breeds that blocks have named.
        private var _named:Vector.<String> = new Vector.<String>();

        /**
         * Creates blocks for the agents of a game.
         *
         * @param collisions has the agents and the collision system in use
         * @throws ArgumentError if it is null
         */
        public function DetectionBlocks(collisions:CollisionBlocks)
        {
            requireGiven("collisions", collisions);
            _collisions = collisions;
            _queries = new AgentQueries(collisions.collision);
        }

        /** The AgentQueries that the blocks use. It sees the agents as they were at the last update. */
        public function get queries():AgentQueries
        {
            return _queries;
        }

        /**
         * Reads the present places of all agents. Call it once a frame, before scripts run. A question before the first call is an
         * IllegalOperationError.
         *
         * @throws ArgumentError as AgentQueries.update
         */
        public function update():void
        {
            _queries.update(_collisions.agents);
        }

        /**
         * Reads the present place of one agent, so that others find it there.
         *
         * @throws ArgumentError as AgentQueries.refresh
         */
        public function moved(agent:Agent):void
        {
            queries.refresh(agent);
        }

        /**
         * The block "count within": counts the agents of a breed within a distance.
         *
         * @param agent the agent that asks
         * @param breed the name of a breed, or Collision.ANY_BREED
         * @param distance in patches, 0 or more
         * @throws BlockError if something is missing, or the distance is negative
         */
        public function countWithin(agent:Agent, breed:String, distance:Number):int
        {
            checkAsker("count within", agent, breed);
            BlockChecks.requireNotNegative("count within", distance, "distance");
            return queries.countNear(agent, distance, filterFor(breed));
        }

        /**
         * The block "count with": counts the agents of a breed with a given value of a trait, at any distance.
         *
         * @param agent the agent that asks
         * @param breed as in countWithin
         * @param trait the name of a trait, for example "color". The class of the breed's agents may have added it
         * @param value the value that the trait must have
         * @throws BlockError if something is missing, or the breed has agents and none of them has such a trait
         */
        public function countWith(agent:Agent, breed:String, trait:String, value:Object):int
        {
            checkAsker("count with", agent, breed);
            return queries.countNear(agent, Infinity, filterFor(breed, testFor("count with", breed, trait, value)));
        }

        /**
         * The block "nearest within": the nearest agent of a breed, if it is within a distance.
         *
         * @param agent as in countWithin
         * @param breed as in countWithin
         * @param distance as in countWithin
         * @return null if there is none
         * @throws BlockError as in countWithin
         */
        public function nearestWithin(agent:Agent, breed:String, distance:Number):Agent
        {
            checkAsker("nearest within", agent, breed);
            BlockChecks.requireNotNegative("nearest within", distance, "distance");
            return queries.nearest(agent, distance, filterFor(breed));
        }

        /**
         * The block "nearest with": the nearest agent of a breed with a given value of a trait.
         *
         * @param agent as in countWith
         * @param breed as in countWith
         * @param trait as in countWith
         * @param value as in countWith
         * @return null if there is none
         * @throws BlockError as in countWith
         */
        public function nearestWith(agent:Agent, breed:String, trait:String, value:Object):Agent
        {
            checkAsker("nearest with", agent, breed);
            return queries.nearest(agent, Infinity, filterFor(breed, testFor("nearest with", breed, trait, value)));
        }

        /**
         * The block "touching?": whether the agent touches another agent, or any agent of a breed.
         *
         * @param agent the agent that asks
         * @param subject an agent, or the name of a breed, or Collision.ANY_BREED, TERRAIN or EDGE
         * @throws BlockError if something is missing
         */
        public function isTouching(agent:Agent, subject:Object):Boolean
        {
            BlockChecks.requireSubject("touching?", subject);
            BlockChecks.requireAgent("touching?", agent);
            if (subject is Agent)
            {
                return subject !== agent && !(agent.isEnvironment && Agent(subject).isEnvironment) && queries.distance(agent, Agent(subject)) == 0;
            }
            if (subject == Collision.EDGE)
            {
                var bounds:WorldBounds = _collisions.collision.bounds;
                return bounds != null && queries.touchesEdge(agent, bounds);
            }
            warnOfBreed(subject as String);
            return queries.touchesAny(agent, filterFor(subject as String));
        }

        /**
         * The block "can see?": whether no agent is on the line between the middles of the two. Agents have the shapes that the collision
         * system uses.
         *
         * @param agent the agent that asks
         * @param other another agent
         * @throws BlockError if something is missing, both are the same agent, or one is the ground's agent or the edges'
         */
        public function canSee(agent:Agent, other:Agent):Boolean
        {
            BlockChecks.requirePair("can see?", agent, other);
            BlockChecks.requirePlacedAgent("can see?", agent);
            BlockChecks.requirePlacedAgent("can see?", other);
            return queries.canSee(agent, other);
        }

        /**
         * The block "distance to": the distance between the surfaces of two agents; 0 if they touch. Agents have the shapes that the
         * collision system uses.
         *
         * @param agent the agent that asks
         * @param other another agent
         * @return patches; Infinity while the model of one is loading
         * @throws BlockError if something is missing, or both are the same agent
         */
        public function distanceTo(agent:Agent, other:Agent):Number
        {
            BlockChecks.requirePair("distance to", agent, other);
            return queries.distance(agent, other);
        }

        /**
         * The block "ahead": the agent of a breed that the agent would touch first, if it went forward by its heading. Agents that it touches
         * already count only if it would go into them.
         *
         * @param agent the agent that asks
         * @param breed as in countWithin; also Collision.TERRAIN, for the ground
         * @param distance how far it looks, in patches, 0 or more
         * @return null if there is none
         * @throws BlockError if something is missing, or the distance is negative, more than 1e9 or not a number
         */
        public function ahead(agent:Agent, breed:String, distance:Number):Agent
        {
            var hit:ShapeHit = hitAhead("ahead", agent, breed, distance);
            return hit == null ? null : hit.agent;
        }

        /**
         * The block "distance ahead": how far the agent can go forward, until it touches an agent of a breed.
         *
         * @param agent as in ahead
         * @param breed as in ahead
         * @param distance as in ahead
         * @return patches; Infinity if there is none within the distance
         * @throws BlockError as in ahead
         */
        public function distanceAhead(agent:Agent, breed:String, distance:Number):Number
        {
            var hit:ShapeHit = hitAhead("distance ahead", agent, breed, distance);
            return hit == null ? Infinity : hit.time * distance;
        }

        /** @private Warns if a breed is probably misspelled. It is looked at once, when a block first names it while the game has agents. */
        engine function warnOfBreed(breed:String):void
        {
            if (_collisions.agents.length > 0 && _named.indexOf(breed) < 0)
            {
                _named.push(breed);
                warnOfMissingBreeds(new <String>[breed], _collisions.agents, null);
            }
        }

        private function hitAhead(block:String, agent:Agent, breed:String, distance:Number):ShapeHit
        {
            checkAsker(block, agent, breed);
            BlockChecks.requireNotNegative(block, distance, "distance");
            BlockChecks.requireNumber(block, distance, "the distance");
            return queries.castAgent(agent, distance * Trigonometry.cosine(agent.heading), distance * Trigonometry.sine(agent.heading), 0, filterFor(breed), _ahead);
        }

        private static function filterFor(breed:String, accepts:Function = null):AgentFilter
        {
            // Each question gets its own filter, because a trait's getter may ask another question meanwhile.
            var filter:AgentFilter = new AgentFilter();
            if (breed == Collision.ANY_BREED)
            {
                // ANY_BREED does not stand for the ground, as in handlers.
                filter.exceptBreeds = new <String>[Collision.TERRAIN];
            }
            else
            {
                filter.breeds = new <String>[breed];
            }
            filter.accepts = accepts;
            return filter;
        }

        private function testFor(block:String, breed:String, trait:String, value:Object):Function
        {
            if (trait == null || isMissing(trait, breed))
            {
                var whose:String = breed == Collision.ANY_BREED ? "no agent has it" : "no agent of the breed \"" + breed + "\" has it";
                throw new BlockError(block, "does not know the trait " + BlockChecks.nameOf(trait) + ": " + whose
                        + ". Check how it is spelled. An agent has breed, shape, size, heading, x, y and z, and what its class adds.");
            }
            return function(agent:Agent):Boolean
            {
                // the breed may have agents of another class, without the trait
                return trait in agent && agent[trait] == value;
            };
        }

        // Whether a breed has agents, and none of them has a trait. A class may add traits, and a breed may have agents of several classes.
        private function isMissing(trait:String, breed:String):Boolean
        {
            var isMissing:Boolean = false;
            for each (var agent:Agent in _collisions.agents)
            {
                if (agent != null && (breed == Collision.ANY_BREED || agent.breed == breed))
                {
                    if (trait in agent)
                    {
                        return false;
                    }
                    isMissing = true;
                }
            }
            return isMissing;
        }

        private function checkAsker(block:String, agent:Agent, breed:String):void
        {
            BlockChecks.requirePlacedAgent(block, agent);
            BlockChecks.requireBreed(block, breed);
            warnOfBreed(breed);
        }
    }
}
