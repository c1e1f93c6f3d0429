package starlogo.collision
{
    import flash.errors.IllegalOperationError;
    import flash.utils.getTimer;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * The client's first collision system (thesis §2.2): every agent is a sphere, whatever its model.
     *
     * <p>The sphere has radius 0.5 and its centre at (0, 0, 0.5) of the model; it is scaled by the agent's size and moved
     * to the agent. Only agents that share a bin of the ground plane are tested (§3.7), each pair once. The other
     * colliders are built on this one: they test other shapes.</p>
     *
     * <p>A frame costs time in proportion to the agents and to the pairs that overlap on the ground plane, memory in
     * proportion to the agents, and allocates nothing once it has run.</p>
     */
    public class BinCollider implements SelectiveCollisionSystem
    {
        private static var sFrame:int = 0;

        /** Has the models of the agents. */
        protected var _greatLand:GreatLand;

        private var _statistics:CollisionStatistics = new CollisionStatistics();
        private var _bins:Bins = new Bins();

        // The mark of its bodies. Another one makes it forget them: when a model was replaced.
        private var _mark:Object = {};
        private var _edition:int = 0;

        // The search under way.
        private var _interests:BreedInterests;
        private var _found:Vector.<Agent>;
        private var _foundLength:int;
        private var _memberCount:int;
        private var _passedOver:int;

        /**
         * A collider for the agents of a game.
         *
         * @param greatLand has the models of the agents
         * @throws ArgumentError if it is null
         */
        public function BinCollider(greatLand:GreatLand)
        {
            if (greatLand == null)
            {
                throw new ArgumentError("greatLand must not be null");
            }
            _greatLand = greatLand;
        }

        /** @inheritDoc */
        public function get statistics():CollisionStatistics
        {
            return _statistics;
        }

        /** @inheritDoc */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            if (a == null || b == null)
            {
                throw new ArgumentError("two agents are needed, not " + a + " and " + b);
            }
            if (a === b)
            {
                throw new ArgumentError(a + " is no pair with itself");
            }
            checkEdition();
            var bodyA:Body = bodyOf(a);
            var bodyB:Body = bodyOf(b);
            return meet(bodyA, bodyB);
        }

        /** @inheritDoc */
        public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return findCollisionsAmong(agents, null, out || new Vector.<Agent>());
        }

        /** @inheritDoc */
        public function findCollisionsAmong(agents:Vector.<Agent>, interests:BreedInterests, out:Vector.<Agent>):Vector.<Agent>
        {
            if (agents == null || out == null)
            {
                throw new ArgumentError((agents == null ? "agents" : "out") + " must not be null");
            }
            var start:int = getTimer();
            enterIntoBins(agents, interests);
            _statistics.reset();
            _interests = interests;
            _found = out;
            _foundLength = 0;
            _passedOver = 0;
            resetCounts();
            _bins.findPairs(this);
            _found = null;
            out.length = _foundLength;
            _statistics.agents = agents.length;
            _statistics.agentsPassedOver = agents.length - _memberCount;
            _statistics.binEntries = _bins.entryCount;
            _statistics.candidatePairs = _bins.pairCount - _passedOver;
            countTests(_statistics);
            _statistics.collisions = _foundLength >> 1;
            _statistics.findMs = getTimer() - start;
            return out;
        }

        /**
         * Whether two bodies' world shapes meet; not called for two spheres.
         *
         * @private
         */
        internal function test(a:Body, b:Body):Boolean
        {
            throw new IllegalOperationError("every body is a sphere");
        }

        /**
         * Finds out what stands for an agent's model.
         *
         * @throws ArgumentError if the model is not known
         * @private
         */
        internal function adopt(body:Body):void
        {
            _greatLand.requireModel(body.agent);
            body.isSphere = true;
        }

        /**
         * Computes a body's world shape and its extents.
         *
         * @private
         */
        internal function place(body:Body):void
        {
            var placement:Placement = body.agent.placement;
            var radius:Number = 0.5 * placement.size;
            body.x = placement.x;
            body.y = placement.y;
            body.z = placement.z + radius;
            body.halfX = body.halfY = body.halfZ = radius;
        }

        /**
         * Begins to count the tests of a search.
         *
         * @private
         */
        internal function resetCounts():void
        {
        }

        /**
         * Counts the tests of the search by their kinds; the candidate pairs are counted already.
         *
         * @private
         */
        internal function countTests(statistics:CollisionStatistics):void
        {
            statistics.sphereSphereTests = statistics.candidatePairs;
        }

        /**
         * Takes a pair whose ground rectangles overlap: tests it, if somebody cares, and keeps it if it collides.
         *
         * @private
         */
        internal final function considerPair(a:Body, b:Body):void
        {
            if (_interests != null && !_interests.includes(a.breed, b.breed))
            {
                _passedOver++;
                return;
            }
            if (a.isSphere && b.isSphere)
            {
                // the most common test by far, without a call
                var dx:Number = a.x - b.x;
                var dy:Number = a.y - b.y;
                var dz:Number = a.z - b.z;
                var reach:Number = a.halfX + b.halfX;
                if (dx * dx + dy * dy + dz * dz > reach * reach)
                {
                    return;
                }
            }
            else if (!test(a, b))
            {
                return;
            }
            var found:Vector.<Agent> = _found;
            var length:int = _foundLength;
            if (a.index < b.index)
            {
                found[length] = a.agent;
                found[length + 1] = b.agent;
            }
            else
            {
                found[length] = b.agent;
                found[length + 1] = a.agent;
            }
            _foundLength = length + 2;
        }

        private function meet(a:Body, b:Body):Boolean
        {
            if (a.isSphere && b.isSphere)
            {
                var dx:Number = a.x - b.x;
                var dy:Number = a.y - b.y;
                var dz:Number = a.z - b.z;
                var reach:Number = a.halfX + b.halfX;
                return dx * dx + dy * dy + dz * dz <= reach * reach;
            }
            return test(a, b);
        }

        private function enterIntoBins(agents:Vector.<Agent>, interests:BreedInterests):void
        {
            checkEdition();
            var mark:Object = _mark;
            var frame:int = ++sFrame;
            var count:int = agents.length;
            _bins.clear();
            _memberCount = 0;
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = agents[i];
                if (agent == null)
                {
                    throw new ArgumentError("agents[" + i + "] is null");
                }
                var body:Body = agent.userData as Body;
                if (body == null || body.owner !== mark)
                {
                    body = adoptAgent(agent);
                }
                if (body.revision != agent.revision)
                {
                    update(body, agent);
                }
                if (body.frame == frame)
                {
                    throw new ArgumentError(agent + " is listed twice: agents[" + body.index + "] and agents[" + i + "]");
                }
                body.frame = frame;
                body.index = i;
                if (interests != null)
                {
                    body.breed = interests.breedIndexOf(agent);
                    if (body.breed < 0)
                    {
                        continue;
                    }
                }
                var level:BinLevel = body.level;
                level.bodies[level.count] = body;
                level.count++;
                _memberCount++;
            }
        }

        private function checkEdition():void
        {
            if (_greatLand.edition != _edition)
            {
                _edition = _greatLand.edition;
                _mark = {};
            }
        }

        // The agent's body, up to date.
        private function bodyOf(agent:Agent):Body
        {
            var body:Body = agent.userData as Body;
            if (body == null || body.owner !== _mark)
            {
                body = adoptAgent(agent);
            }
            if (body.revision != agent.revision)
            {
                update(body, agent);
            }
            return body;
        }

        private function adoptAgent(agent:Agent):Body
        {
            var body:Body = new Body(agent, _mark);
            adopt(body);
            agent.userData = body;
            return body;
        }

        private function update(body:Body, agent:Agent):void
        {
            place(body);
            body.revision = agent.revision;
            if (body.form != agent.form)
            {
                body.form = agent.form;
                _bins.assignLevel(body);
            }
            else if (body.x * body.x + body.y * body.y >= body.level.reachSquared)
            {
                _bins.assignLevel(body);
            }
        }
    }
}
