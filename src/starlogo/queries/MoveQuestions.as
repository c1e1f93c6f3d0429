package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.geometry.requireInWorld;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Answers how far an agent or a structure can go. Some questions move the agent there. The casts move nothing.
     *
     * @private
     */
    public final class MoveQuestions
    {
        /** Computes where moving rows end. */
        public var mover:Mover = null;

        /** The motion of the last question. */
        public var way:Vector3D = new Vector3D();

        /** The agents that count and are near the way of the last question. */
        public var agents:Vector.<Agent> = new Vector.<Agent>();

        private var _seen:SeenAgents;

        private var _pool:HitPool = new HitPool(ShapeHit);
        private var _single:Vector.<Agent> = new <Agent>[null];

        // The first contact on the way, and the place where it stops the body.
        private var _first:ContactPoint = new ContactPoint();
        private var _firstAt:Vector3D = new Vector3D();

        // The rows near the way, all with the distance 0. Then the rows that a cast meets, with their times.
        private var _search:WaySearch = new WaySearch();
        private var _found:Collector;

        /** @param seen the agents that questions are about */
        public function MoveQuestions(seen:SeenAgents)
        {
            _seen = seen;
            _found = new Collector(seen);
        }

        /**
         * Moves an agent. See AgentQueries.moveUntilTouch and AgentQueries.slide.
         *
         * @param contact receives the contact; or null
         * @param ending Mover.TOUCH or Mover.SLIDE
         * @return the free part of the motion
         */
        public function move(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, contact:Contact, ending:int):Number
        {
            // an agent that slides may go anywhere within the length of its way
            var reach:Number = ending == Mover.SLIDE ? Math.sqrt(dx * dx + dy * dy + dz * dz) : 0;
            var body:Body = begin(agent, null, dx, dy, dz, filter, reach);
            if (ending == Mover.SLIDE)
            {
                mover.move(_seen.table, body, agents, way, ending);
            }
            else
            {
                findFirst(body, ending);
            }
            if (contact != null)
            {
                writeContact(contact);
            }
            if (dx != 0 || dy != 0 || dz != 0)
            {
                put(agent);
            }
            return mover.part;
        }

        /** Puts an agent where the mover has come to. */
        public function put(agent:Agent):void
        {
            agent.moveTo(mover.at.x, mover.at.y, mover.at.z);
            if (_seen.table.rowOf(agent) >= 0)
            {
                _seen.moved(agent);
            }
        }

        /**
         * Casts an agent or a structure. See AgentQueries.castAgent and AgentQueries.castShape.
         *
         * @param agent the agent that is cast, if there is no structure
         * @param structure the structure that is cast; null to cast the agent
         */
        public function cast(agent:Agent, structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            findFirst(begin(agent, structure, dx, dy, dz, filter), Mover.SHORT);
            return mover.hasContact ? write(hit || new ShapeHit()) : null;
        }

        /** See AgentQueries.castAgentAll and AgentQueries.castShapeAll. The parameters are those of <code>cast()</code>. */
        public function castAll(agent:Agent, structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter,
                out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            var hits:Vector.<ShapeHit> = out || new Vector.<ShapeHit>();
            var body:Body = begin(agent, structure, dx, dy, dz, filter);
            _found.begin(Collector.ALL, Infinity, null, null);
            for (var i:int = 0; i < agents.length; i++)
            {
                _single[0] = agents[i];
                mover.move(_seen.table, body, _single, way, Mover.SHORT);
                if (mover.hasContact)
                {
                    _found.add(mover.contactRow, mover.part);
                }
            }
            _found.list(agents);
            _pool.fit(hits, agents.length);
            for (i = 0; i < agents.length; i++)
            {
                _single[0] = agents[i];
                mover.move(_seen.table, body, _single, way, Mover.SHORT);
                write(hits[i]);
            }
            return hits;
        }

        /**
         * Finds the agents near a way, and returns the body that moves.
         *
         * @param reach how far the body may go in any direction. If it is 0, the body goes only along the motion
         * @param up how much farther it may go upwards
         * @param down how much farther it may go downwards
         */
        public function begin(agent:Agent, structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter, reach:Number = 0,
                up:Number = 0, down:Number = 0):Body
        {
            requireInWorld("a motion", dx, dy, dz);
            if (structure == null)
            {
                _seen.placeOf(agent);
            }
            var body:Body = _seen.bodyOfEither(agent, structure);
            _found.begin(Collector.ALL, Infinity, agent, filter);
            if (body.shape != null)
            {
                _seen.beginWay(_search, body);
                _search.widen(reach, up, down);
                if (reach == 0)
                {
                    _search.moveAlong(dx, dy, dz, 1);
                }
                findNear();
            }
            // the filter may ask other questions, so all that they share is set afterwards
            _found.list(agents);
            way.setTo(dx, dy, dz);
            if (mover == null || mover.pairs !== _seen.pairs)
            {
                mover = new Mover(_seen.pairs);
            }
            return _seen.bodyOfEither(agent, structure);
        }

        // Finds the agent that stops the body first, each as if the others were not there. If several stop it at the same time, it is the first of
        // them in the list.
        private function findFirst(body:Body, ending:int):void
        {
            _found.begin(1, Infinity, null, null);
            if (agents.length == 0)
            {
                mover.move(_seen.table, body, agents, way, ending);
            }
            for (var i:int = 0; i < agents.length && _found.limit > 0; i++)
            {
                _single[0] = agents[i];
                mover.move(_seen.table, body, _single, way, ending);
                if (mover.hasContact && _found.add(mover.contactRow, mover.part))
                {
                    _first.copyFrom(mover.contact);
                    _firstAt.copyFrom(mover.at);
                }
            }
            if (_found.end() > 0)
            {
                mover.hasContact = true;
                mover.contactRow = _found.rows[0];
                mover.part = _found.limit;
                mover.contact.copyFrom(_first);
                mover.at.copyFrom(_firstAt);
            }
        }

        private function findNear():void
        {
            for (var other:int = _search.next(); other >= 0; other = _search.next())
            {
                if (_found.admits(other))
                {
                    _found.add(other, 0);
                }
            }
        }

        // Writes how the last row that moved touches the agent that stopped it.
        private function write(hit:ShapeHit):ShapeHit
        {
            var contact:ContactPoint = mover.contact;
            hit.agent = _seen.table.agents[mover.contactRow];
            hit.time = mover.part;
            hit.point.setTo(contact.x, contact.y, contact.z);
            hit.normal.setTo(contact.normalX, contact.normalY, contact.normalZ);
            return hit;
        }

        private function writeContact(out:Contact):void
        {
            var contact:ContactPoint = mover.contact;
            out.time = mover.part;
            if (mover.hasContact)
            {
                out.point.setTo(contact.x, contact.y, contact.z);
                out.normal.setTo(contact.normalX, contact.normalY, contact.normalZ);
                out.depth = contact.depth;
                out.approachSpeed = Math.max(0, -contact.along(way));
            }
        }
    }
}
