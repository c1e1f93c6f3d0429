package starlogo.blocks
{
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;

    /**
     * The blocks that ask about other agents: "count within", "count with", "nearest within", "nearest with", "touching?", "can see?", "distance to". The agent that asks
     * is never in an answer. It is where it is; the others are where they were when the frame began, or when <code>moved()</code> told of them.
     */
    public class DetectionBlocks
    {
        private var _collisions:CollisionBlocks;
        private var _queries:AgentQueries;
        private var _updatedIn:int = -1;

        /**
         * Blocks for the agents of a game.
         *
         * @param collisions know the agents, and the collision system in use
         * @throws ArgumentError if it is null
         */
        public function DetectionBlocks(collisions:CollisionBlocks)
        {
            if (collisions == null)
            {
                throw new ArgumentError("collision blocks are needed, not null");
            }
            _collisions = collisions;
            _queries = new AgentQueries(collisions.collision);
        }

        /** The questions that the blocks ask, with the agents of the last update. */
        public function get queries():AgentQueries
        {
            if (_updatedIn != _collisions.runs)
            {
                update();
            }
            return _queries;
        }

        /**
         * Takes the game's agents where they are: once a frame, before scripts run.
         *
         * @throws ArgumentError as AgentQueries.update does
         */
        public function update():void
        {
            _queries.update(_collisions.agents);
            _updatedIn = _collisions.runs;
        }

        /**
         * Takes one agent where it is now, so that others find it there.
         *
         * @throws ArgumentError as AgentQueries.moved does
         */
        public function moved(agent:Agent):void
        {
            queries.moved(agent);
        }

        /**
         * The block "count within": how many agents of a breed are within a distance.
         *
         * @param agent asks
         * @param breed the name of a breed, or Collision.ANY_BREED
         * @param distance in patches
         * @throws BlockError if something is missing, or the distance is negative
         */
        public function countWithin(agent:Agent, breed:String, distance:Number):int
        {
            check("count within", agent, breed);
            checkDistance("count within", distance);
            return queries.countNear(agent, distance, filterFor(breed));
        }

        /**
         * The block "count with": how many agents of a breed have a trait of a value, wherever they are.
         *
         * @param agent asks
         * @param breed as in countWithin
         * @param trait the name of a trait, as "color"
         * @param value what it has to be
         * @throws BlockError if something is missing, or agents have no such trait
         */
        public function countWith(agent:Agent, breed:String, trait:String, value:Object):int
        {
            check("count with", agent, breed);
            return queries.countNear(agent, Infinity, filterFor(breed, testFor("count with", agent, trait, value)));
        }

        /**
         * The block "nearest within": the agent of a breed that is nearest, if it is within a distance.
         *
         * @param agent as in countWithin
         * @param breed as in countWithin
         * @param distance as in countWithin
         * @return null if there is none
         * @throws BlockError as in countWithin
         */
        public function nearestWithin(agent:Agent, breed:String, distance:Number):Agent
        {
            check("nearest within", agent, breed);
            checkDistance("nearest within", distance);
            return queries.nearest(agent, distance, filterFor(breed));
        }

        /**
         * The block "nearest with": the agent of a breed that is nearest of those that have a trait of a value.
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
            check("nearest with", agent, breed);
            return queries.nearest(agent, Infinity, filterFor(breed, testFor("nearest with", agent, trait, value)));
        }

        /**
         * The block "touching?": whether the agent touches another, or one of a breed.
         *
         * @param agent asks
         * @param subject an agent, or the name of a breed, or Collision.ANY_BREED
         * @throws BlockError if something is missing
         */
        public function isTouching(agent:Agent, subject:Object):Boolean
        {
            BlockSubject.check("touching?", subject);
            var breed:String = subject is Agent ? Collision.ANY_BREED : subject as String;
            check("touching?", agent, breed);
            return queries.touchesAny(agent, filterFor(breed, subject is Agent ? isOne(subject) : null));
        }

        /**
         * The block "can see?": whether no agent is between the middles of the two, as the collision system sees agents.
         *
         * @param agent asks
         * @param other another agent
         * @throws BlockError if something is missing, or both are one
         */
        public function canSee(agent:Agent, other:Agent):Boolean
        {
            checkBoth("can see?", agent, other);
            return queries.canSee(agent, other);
        }

        /**
         * The block "distance to": how far the surfaces of the agent and another are apart, as the collision system sees them; 0 if they touch.
         *
         * @param agent asks
         * @param other another agent
         * @return patches; Infinity while the model of one is loading
         * @throws BlockError if something is missing, or both are one
         */
        public function distanceTo(agent:Agent, other:Agent):Number
        {
            checkBoth("distance to", agent, other);
            return queries.distance(agent, other);
        }

        private static function filterFor(breed:String, accepts:Function = null):AgentFilter
        {
            // one for each question: a trait's getter may ask another while this is being asked
            var filter:AgentFilter = breed == Collision.ANY_BREED ? new AgentFilter() : AgentFilter.ofBreeds(breed);
            filter.accepts = accepts;
            return filter;
        }

        private static function isOne(wanted:Object):Function
        {
            return function(agent:Agent):Boolean
            {
                return agent === wanted;
            };
        }

        private static function testFor(block:String, asker:Agent, trait:String, value:Object):Function
        {
            if (trait == null || !(trait in asker))
            {
                throw new BlockError(block, "does not know the trait " + BlockSubject.nameOf(trait) + ". Check how it is spelled.");
            }
            return function(agent:Agent):Boolean
            {
                return agent[trait] == value;
            };
        }

        private static function check(block:String, agent:Agent, breed:String):void
        {
            if (agent == null)
            {
                throw new BlockError(block, "needs an agent that asks, but got nothing. Remember: \"collidee\" is an agent only while a collision block runs.");
            }
            BlockSubject.checkBreed(block, breed);
        }

        private static function checkBoth(block:String, agent:Agent, other:Agent):void
        {
            check(block, agent, Collision.ANY_BREED);
            if (other == null || other === agent)
            {
                throw new BlockError(block, "needs another agent, but got " + (other == null ? "nothing" : "the same") + ".");
            }
        }

        private static function checkDistance(block:String, distance:Number):void
        {
            if (!(distance >= 0))
            {
                throw new BlockError(block, "needs a distance of 0 or more, but got " + distance + ".");
            }
        }
    }
}
