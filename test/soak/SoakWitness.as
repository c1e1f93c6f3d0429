package soak
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.Footing;
    import starlogo.queries.RayHit;
    import starlogo.queries.WalkOptions;
    import support.RunningHash;

    /**
     * Sees all that a game can see, and makes a hash of it: calls in their order, contacts, the answers to every kind of question, snapshots, and
     * the bytes of the fits that are kept. Draws no random numbers.
     */
    internal final class SoakWitness
    {
        // in each of the first some of which all pairs have a handler
        private static const PERIOD:int = 40;
        private static const ALL_PAIRS:int = 8;

        // a walk takes as long as many other questions
        private static const WALK_EVERY:int = 5;

        private var _collision:Collision;
        private var _models:SoakModels;
        private var _queries:AgentQueries;
        private var _hash:RunningHash = new RunningHash();
        private var _frame:int = 0;
        private var _firstId:int = new Agent("sphere").id;
        private var _filter:AgentFilter = AgentFilter.ofBreeds("bears", "balls", "walls");
        private var _found:Vector.<Agent> = new Vector.<Agent>();
        private var _hits:Vector.<RayHit> = new Vector.<RayHit>();
        private var _hit:RayHit = new RayHit();
        private var _pointA:Vector3D = new Vector3D();
        private var _pointB:Vector3D = new Vector3D();
        private var _contact:Contact = new Contact();
        private var _options:WalkOptions = new WalkOptions();
        private var _footing:Footing = new Footing();

        /**
         * @param collision is asked
         * @param models have the fits
         */
        public function SoakWitness(collision:Collision, models:SoakModels)
        {
            _collision = collision;
            _models = models;
            _queries = new AgentQueries(collision);
        }

        /** The hash: eight hexadecimal digits. */
        public function toString():String
        {
            return _hash.toString();
        }

        /** A call. */
        internal function seePair(collider:Agent, collidee:Agent):void
        {
            seeAgent(collider);
            seeAgent(collidee);
        }

        /** A call with a contact. */
        internal function seeContact(collider:Agent, collidee:Agent, contact:Contact):void
        {
            seePair(collider, collidee);
            seeTouch(contact);
        }

        /** The agents after a frame: asks of some of them. */
        internal function seeFrame(agents:Vector.<Agent>, isModelGone:Boolean):void
        {
            _hash.addShort(_collision.statistics.collisions);
            _hash.addShort(_collision.statistics.tests);
            _hash.addShort(_collision.handlerErrors.length);
            if (!isModelGone)
            {
                _queries.update(agents);
                ask(agents[_frame % agents.length], agents[(7 * _frame + 3) % agents.length]);
            }
            if (_frame % PERIOD == 0)
            {
                _collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, seeContact);
            }
            else if (_frame % PERIOD == ALL_PAIRS)
            {
                _collision.removeHandler(Collision.ANY_BREED, Collision.ANY_BREED, seeContact);
                seeFits();
            }
            if (_frame % PERIOD == PERIOD / 2)
            {
                seeSnapshot();
            }
            _frame++;
        }

        private function ask(agent:Agent, other:Agent):void
        {
            var filter:AgentFilter = _frame % 2 == 0 ? _filter : null;
            var radius:Number = 1 + _frame % 5;
            var middle:Vector3D = new Vector3D(agent.x, agent.y, agent.z + 0.5);
            var direction:Vector3D = new Vector3D(other.x - agent.x, other.y - agent.y, other.z - agent.z + 0.1);
            seeAgents(_queries.near(agent, radius, filter, _found));
            seeAgents(_queries.inCone(agent, 2 * radius, 90, filter, _found));
            seeAgents(_queries.touching(agent, filter, _found));
            seeAgents(_queries.overlapping(new Sphere(middle, 0.4 * radius), filter, _found));
            seeAgents(_queries.overlapping(new Box(middle, Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 0.5, 0.3), filter, _found));
            seeAgent(_queries.nearest(agent, Infinity, filter));
            seeAgent(_queries.nearestToPoint(direction, Infinity, filter));
            _hash.addShort(_queries.countNear(agent, radius, filter));
            if (agent != other)
            {
                _hash.addNumber(_queries.distance(agent, other, _pointA, _pointB));
                seeVector(_pointA);
                seeVector(_pointB);
                _hash.addShort(_queries.canSee(agent, other, filter) ? 1 : 0);
            }
            seeHit(_queries.cast(middle, direction, Infinity, filter, _hit));
            for each (var hit:RayHit in _queries.castAll(middle, direction, 10, filter, _hits))
            {
                seeHit(hit);
            }
            askForMoves(agent, direction, filter);
        }

        private function askForMoves(agent:Agent, direction:Vector3D, filter:AgentFilter):void
        {
            var x:Number = agent.x;
            var y:Number = agent.y;
            var z:Number = agent.z;
            _hash.addNumber(_queries.moveUntilTouch(agent, direction.x, direction.y, direction.z, filter, _contact));
            seeTouch(_contact);
            _hash.addNumber(_queries.slide(agent, direction.y, -direction.x, 0.1, filter));
            seePlace(agent);
            agent.moveTo(x, y, z);
            if (_frame % WALK_EVERY == 0)
            {
                askOfTheGround(agent, direction);
                agent.moveTo(x, y, z);
            }
        }

        private function askOfTheGround(agent:Agent, direction:Vector3D):void
        {
            seeFooting(_queries.walk(agent, direction.x, direction.y, _options, _footing));
            seePlace(agent);
            _hash.addNumber(_queries.distance(agent, _collision.terrain.agent, _pointA, _pointB));
            seeVector(_pointA);
            seeVector(_pointB);
            _hash.addShort(_queries.touchesEdge(agent, _collision.bounds) ? 1 : 0);
            _hash.addNumber(_collision.terrain.heightAt(agent.x, agent.y));
        }

        private function seePlace(agent:Agent):void
        {
            _hash.addNumber(agent.x);
            _hash.addNumber(agent.y);
            _hash.addNumber(agent.z);
        }

        private function seeFooting(footing:Footing):void
        {
            _hash.addShort(footing.stands ? 1 : 0);
            seeAgent(footing.on);
            seeVector(footing.normal);
            _hash.addNumber(footing.part);
        }

        private function seeSnapshot():void
        {
            try
            {
                var bytes:ByteArray = _collision.snapshot();
                // without the kind of the collision system, which the game has chosen
                bytes[4] &= 7;
                _hash.addBytes(bytes);
            }
            catch (error:IllegalOperationError)
            {
                // the frame has refused its list: there is no snapshot of it
                _hash.addShort(1);
            }
        }

        private function seeFits():void
        {
            for each (var name:String in _models.storage.names)
            {
                _hash.addBytes(_models.storage.entries[name]);
            }
        }

        private function seeAgents(agents:Vector.<Agent>):void
        {
            _hash.addShort(agents.length);
            for each (var agent:Agent in agents)
            {
                seeAgent(agent);
            }
        }

        private function seeAgent(agent:Agent):void
        {
            // the edges' agent has the id 0, whenever it was made
            _hash.addShort(agent == null ? 0 : agent.breed == Collision.EDGE ? -1 : agent.id - _firstId);
        }

        private function seeHit(hit:RayHit):void
        {
            seeAgent(hit == null ? null : hit.agent);
            if (hit != null)
            {
                _hash.addNumber(hit.distance);
                seeVector(hit.point);
                seeVector(hit.normal);
            }
        }

        private function seeTouch(contact:Contact):void
        {
            _hash.addNumber(contact.time);
            _hash.addNumber(contact.depth);
            seeVector(contact.point);
            seeVector(contact.normal);
        }

        private function seeVector(vector:Vector3D):void
        {
            _hash.addNumber(vector.x);
            _hash.addNumber(vector.y);
            _hash.addNumber(vector.z);
        }
    }
}
