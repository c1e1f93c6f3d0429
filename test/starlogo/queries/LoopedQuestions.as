package starlogo.queries
{

    import flash.geom.Vector3D;
    import starlogo.agents.Agent;

    /** Answers to questions about places by loops over all agents, as they were last seen. */
    public final class LoopedQuestions
    {
        // Of an angle between vectors, in radians. Agents exactly on the border of a cone are in it.
        private static const ROUNDING:Number = 2e-15;

        // Of the square of a radius, which reaches as far as a computed distance.
        private static const REACH:Number = 1 + 2e-15;

        private var _agents:Vector.<Agent>;
        private var _places:Vector.<Vector3D>;

        /** As AgentQueries.update. */
        public function update(agents:Vector.<Agent>):void
        {
            _agents = agents.concat();
            _places = new Vector.<Vector3D>();
            for each (var agent:Agent in agents)
            {
                _places.push(new Vector3D(agent.x, agent.y, agent.z));
            }
        }

        /** As AgentQueries.moved. */
        public function moved(agent:Agent):void
        {
            _places[_agents.indexOf(agent)].setTo(agent.x, agent.y, agent.z);
        }

        /** How far an agent is from where another was seen. */
        public function distance(agent:Agent, other:Agent):Number
        {
            return Math.sqrt(square(agent.x, agent.y, agent.z, _agents.indexOf(other)));
        }

        /** Who is near a place, but for one agent, in order. */
        public function near(x:Number, y:Number, z:Number, asker:Agent, radius:Number, filter:AgentFilter):Vector.<Agent>
        {
            var near:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < _agents.length; i++)
            {
                if (_agents[i] != asker && square(x, y, z, i) <= REACH * radius * radius)
                {
                    near.push(_agents[i]);
                }
            }
            return filtered(sorted(x, y, z, near), filter);
        }

        /** Some agents in order. */
        public function sorted(x:Number, y:Number, z:Number, agents:Vector.<Agent>):Vector.<Agent>
        {
            var listed:Vector.<Agent> = _agents;
            var self:LoopedQuestions = this;
            var result:Vector.<Agent> = agents.concat();
            result.sort(function(a:Agent, b:Agent):Number
                {
                    var placeA:int = listed.indexOf(a);
                    var placeB:int = listed.indexOf(b);
                    var squareA:Number = self.square(x, y, z, placeA);
                    var squareB:Number = self.square(x, y, z, placeB);
                    if (squareA == squareB)
                    {
                        return placeA - placeB;
                    }
                    return squareA < squareB ? -1 : 1;
                });
            return result;
        }

        /** Those that a filter lets through. */
        public function filtered(agents:Vector.<Agent>, filter:AgentFilter):Vector.<Agent>
        {
            var left:Vector.<Agent> = new Vector.<Agent>();
            for each (var agent:Agent in agents)
            {
                if (filter == null || passes(agent, filter))
                {
                    left.push(agent);
                }
            }
            return left;
        }

        /** Those of an ordered list that are in a cone, by Matrix3D and angles between vectors. */
        public function inCone(asker:Agent, near:Vector.<Agent>, degrees:Number):Vector.<Agent>
        {
            var forward:Vector3D = asker.transform.deltaTransformVector(Vector3D.X_AXIS);
            var inside:Vector.<Agent> = new Vector.<Agent>();
            for each (var agent:Agent in near)
            {
                var place:Vector3D = _places[_agents.indexOf(agent)];
                var to:Vector3D = new Vector3D(place.x - asker.x, place.y - asker.y, place.z - asker.z);
                if (degrees >= 360 || to.length == 0 || Vector3D.angleBetween(forward, to) <= degrees * Math.PI / 360 + ROUNDING)
                {
                    inside.push(agent);
                }
            }
            return inside;
        }

        /** The ids of agents. */
        public static function numbers(agents:Vector.<Agent>):String
        {
            var numbers:Array = [];
            for each (var agent:Agent in agents)
            {
                numbers.push(agent.id);
            }
            return numbers.join();
        }

        private function square(x:Number, y:Number, z:Number, i:int):Number
        {
            x = _places[i].x - x;
            y = _places[i].y - y;
            z = _places[i].z - z;
            return x * x + y * y + z * z;
        }

        private static function passes(agent:Agent, filter:AgentFilter):Boolean
        {
            return (filter.breeds == null || filter.breeds.indexOf(agent.breed) >= 0)
                && (filter.exceptBreeds == null || filter.exceptBreeds.indexOf(agent.breed) < 0)
                && (filter.except == null || filter.except.indexOf(agent) < 0)
                && (filter.accepts == null || filter.accepts(agent));
        }
    }
}
