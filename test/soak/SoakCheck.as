package soak
{
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.Contact;

    /**
     * Compares the calls of one frame with brute force: every pair of agents, as it stands, or where one of them sweeps, at moments of its
     * way. What brute force sees must have been found, no later than that; what was found must touch at its time.
     */
    internal final class SoakCheck
    {
        private static const MOMENTS:int = 32;
        private static const SHORTLY:Number = 1e-7;

        // in patches; the player's matrices have single precision
        private static const CLOSER:Number = 1e-5;

        private var _models:SoakModels;
        private var _systems:SoakSystems;
        private var _counts:SoakCounts;

        // where an agent was in the frame before, by its id: the Agent's shape and place then
        private var _last:Object = {};

        // when pairs touch, and the normal from the second to the first, by the two ids; and which handlers were called for them
        private var _times:Object = {};
        private var _normals:Object = {};
        private var _calls:Object = {};

        private var _agents:Vector.<Agent>;
        private var _doubles:Vector.<Agent>;
        private var _ways:Vector.<Agent>;

        /**
         * @param models has the agents' models
         * @param systems answers for pairs
         * @param counts is told
         */
        public function SoakCheck(models:SoakModels, systems:SoakSystems, counts:SoakCounts)
        {
            _models = models;
            _systems = systems;
            _counts = counts;
        }

        /** Remembers where the agents are, right before the frame before that of the check. */
        internal function remember(agents:Vector.<Agent>):void
        {
            _last = {};
            for each (var agent:Agent in agents)
            {
                if (_models.greatLand.hasModel(agent.shape))
                {
                    _last[agent.id] = doubleOf(agent);
                }
            }
        }

        /** An agent has jumped. */
        internal function forget(agent:Agent):void
        {
            delete _last[agent.id];
        }

        /** Takes the agents as they are, right before the frame of the check. */
        internal function begin(agents:Vector.<Agent>):void
        {
            var greatLand:GreatLand = _models.greatLand;
            _times = {};
            _normals = {};
            _calls = {};
            _agents = agents.filter(function(agent:Agent, index:int, all:Vector.<Agent>):Boolean
                {
                    return greatLand.hasModel(agent.shape);
                });
            // in the order of their ids: trees of capsules decide a close pair by who came first
            _agents.sort(compareIds);
            _doubles = _agents.map(function(agent:Agent, index:int, all:Vector.<Agent>):Agent
                {
                    return doubleOf(agent);
                });
            _ways = _agents.map(function(agent:Agent, index:int, all:Vector.<Agent>):Agent
                {
                    var last:Agent = _last[agent.id];
                    return last != null && last.shape == agent.shape ? last : null;
                });
        }

        /** Notes a call in that frame. */
        internal function note(handler:SoakHandler, collider:Agent, collidee:Agent, system:Collider):void
        {
            var key:String = collider.id + " " + collidee.id;
            var back:String = collidee.id + " " + collider.id;
            _calls[key] ||= [];
            _calls[key].push(handler);
            var contact:Contact = system.contactOf(collider, collidee);
            var normal:Vector3D = contact.normal.clone();
            _times[key] = _times[back] = contact.time;
            _normals[key] = normal;
            _normals[back] = new Vector3D(-normal.x, -normal.y, -normal.z);
        }

        /**
         * Compares.
         *
         * @param handlers that there were
         * @return what is wrong, or ""
         */
        internal function verdict(system:Collider, handlers:Vector.<SoakHandler>):String
        {
            _systems.beginReference(system);
            for (var i:int = 0; i < _agents.length; i++)
            {
                for (var j:int = i + 1; j < _agents.length; j++)
                {
                    var problem:String = verdictOf(i, j, handlers);
                    if (problem != "")
                    {
                        return _systems.name + ": " + describe(i) + " and " + describe(j) + " " + problem;
                    }
                }
            }
            for (var key:String in _calls)
            {
                return "a call for the agents " + key + ", who are not there";
            }
            _counts.add("frames checked");
            return "";
        }

        private function verdictOf(i:int, j:int, handlers:Vector.<SoakHandler>):String
        {
            var time:* = _times[_agents[i].id + " " + _agents[j].id];
            var isFound:Boolean = time !== undefined;
            if (isFound && !areCallsRight(_agents[i], _agents[j], handlers))
            {
                return "did not meet the handlers that they should";
            }
            if (!areNear(i, j))
            {
                return isFound ? "are found, but far from each other" : "";
            }
            if (!isFound && !isAnybodyInterested(_agents[i], _agents[j], handlers))
            {
                return "";
            }
            _counts.add("pairs checked");
            return (isSweeping(i) || isSweeping(j)) && (hasMoved(i) || hasMoved(j)) ? verdictOfWays(i, j, time) : verdictOfStanding(i, j, time);
        }

        private function verdictOfStanding(i:int, j:int, time:*):String
        {
            var isSeen:Boolean = collideAt(i, j, 1);
            _counts.add("collisions confirmed", isSeen ? 1 : 0);
            return isSeen == (time === 1) ? "" : isSeen ? "are missed, or found at " + time : "do not touch";
        }

        private function verdictOfWays(i:int, j:int, time:*):String
        {
            var isFound:Boolean = time !== undefined;
            _counts.add("pairs checked along their ways");
            for (var k:int = 0; k <= MOMENTS; k++)
            {
                if (collideAt(i, j, k / MOMENTS))
                {
                    if (!isFound || time > k / MOMENTS + SHORTLY)
                    {
                        return isFound ? "meet at " + k / MOMENTS + ", not " + time : "are missed";
                    }
                    break;
                }
            }
            if (isFound && !collideAt(i, j, time) && !collideCloser(i, j))
            {
                return "do not touch at " + time;
            }
            _counts.add("collisions on ways confirmed", isFound ? 1 : 0);
            return "";
        }

        private function areCallsRight(a:Agent, b:Agent, handlers:Vector.<SoakHandler>):Boolean
        {
            return areCallsInOrder(a, b, handlers) && areCallsInOrder(b, a, handlers);
        }

        // Each handler that cares was called once, in the order in which they were added; those calls are done with.
        private function areCallsInOrder(collider:Agent, collidee:Agent, handlers:Vector.<SoakHandler>):Boolean
        {
            var key:String = collider.id + " " + collidee.id;
            var calls:Array = _calls[key] || [];
            delete _calls[key];
            for each (var handler:SoakHandler in handlers)
            {
                if (handler.cares(collider, collidee) && calls.shift() != handler)
                {
                    return false;
                }
            }
            return calls.length == 0;
        }

        private static function isAnybodyInterested(a:Agent, b:Agent, handlers:Vector.<SoakHandler>):Boolean
        {
            for each (var handler:SoakHandler in handlers)
            {
                if (handler.cares(a, b) || handler.cares(b, a))
                {
                    return true;
                }
            }
            return false;
        }

        private function areNear(i:int, j:int):Boolean
        {
            place(i, 0.5);
            place(j, 0.5);
            var reach:Number = reachOf(i) + reachOf(j);
            var x:Number = _doubles[i].x - _doubles[j].x;
            var y:Number = _doubles[i].y - _doubles[j].y;
            var z:Number = _doubles[i].z - _doubles[j].z;
            return x * x + y * y + z * z <= reach * reach;
        }

        // Around the middle of its way.
        private function reachOf(i:int):Number
        {
            var way:Number = 0;
            if (_ways[i] != null)
            {
                way = Math.abs(_agents[i].x - _ways[i].x) + Math.abs(_agents[i].y - _ways[i].y) + Math.abs(_agents[i].z - _ways[i].z);
            }
            return _models.reachOf(_agents[i].shape) * _agents[i].size + way / 2;
        }

        private function isSweeping(i:int):Boolean
        {
            return _agents[i].sweeps && _ways[i] != null;
        }

        private function hasMoved(i:int):Boolean
        {
            var agent:Agent = _agents[i];
            return _ways[i] != null && (agent.x != _ways[i].x || agent.y != _ways[i].y || agent.z != _ways[i].z);
        }

        private function collideAt(i:int, j:int, time:Number):Boolean
        {
            place(i, time);
            place(j, time);
            return _systems.areColliding(_doubles[i], _doubles[j]);
        }

        // As they stand, but moved together a bit: those that graze each other do so for no time at all.
        private function collideCloser(i:int, j:int):Boolean
        {
            var normal:Vector3D = _normals[_agents[i].id + " " + _agents[j].id];
            var twin:Agent = _doubles[i];
            twin.moveTo(twin.x - CLOSER * normal.x, twin.y - CLOSER * normal.y, twin.z - CLOSER * normal.z);
            return _systems.areColliding(twin, _doubles[j]);
        }

        private function place(i:int, time:Number):void
        {
            var to:Agent = _agents[i];
            var from:Agent = _ways[i] || to;
            var back:Number = 1 - time;
            _doubles[i].moveTo(to.x - back * (to.x - from.x), to.y - back * (to.y - from.y), to.z - back * (to.z - from.z));
        }

        private function describe(i:int):String
        {
            var agent:Agent = _agents[i];
            return agent + " at " + placeOf(agent) + " from " + (_ways[i] == null ? "nowhere" : placeOf(_ways[i])) + " of size " +
                agent.size + ", turned by " + [agent.heading, agent.pitch, agent.roll] + ", as " + agent.collideAs +
                (agent.hierarchical ? ", hierarchical" : "") + ", of depth " + agent.traversalDepth + (isSweeping(i) ? ", sweeping" : "");
        }

        private static function placeOf(agent:Agent):String
        {
            return "(" + agent.x + ", " + agent.y + ", " + agent.z + ")";
        }

        private static function compareIds(a:Agent, b:Agent):int
        {
            return a.id - b.id;
        }

        private static function doubleOf(agent:Agent):Agent
        {
            var twin:Agent = new Agent(agent.shape);
            twin.moveTo(agent.x, agent.y, agent.z);
            twin.size = agent.size;
            twin.heading = agent.heading;
            twin.pitch = agent.pitch;
            twin.roll = agent.roll;
            twin.collideAs = agent.collideAs;
            twin.hierarchical = agent.hierarchical;
            twin.traversalDepth = agent.traversalDepth;
            return twin;
        }
    }
}
