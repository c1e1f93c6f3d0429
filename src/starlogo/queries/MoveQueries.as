package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
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
    public final class MoveQueries
    {
        /** Computes where moving bodies end. */
        public var mover:Mover = null;

        /** The body that moves, as it was at the beginning of the last question. */
        public var body:Body;

        /** The rows that count and are near the way of the last question, in the order of the list. */
        public var near:Vector.<int> = new Vector.<int>();

        /** The number of these rows. */
        public var nearCount:int = 0;

        private var _seen:QueryWorld;
        private var _bodies:QueryBodies;
        private var _found:Collector;
        private var _search:SweptBoxSearch;

        // The last number of a hit is the depth.
        private var _hits:Hits;
        private var _copy:Body = new Body();
        private var _way:Vector3D = new Vector3D();

        // The place where the row that is met first stops the body.
        private var _end:Vector3D = new Vector3D();

        /**
         * @param seen the agents that questions are about
         * @param bodies the bodies that ask
         * @param found collects the rows near a way, and then those that are met
         * @param search finds the rows near a way
         */
        public function MoveQueries(seen:QueryWorld, bodies:QueryBodies, found:Collector, search:SweptBoxSearch)
        {
            _seen = seen;
            _bodies = bodies;
            _found = found;
            _search = search;
            _hits = new Hits(found, ShapeHit);
        }

        /** See AgentQueries.moveUntilTouch. */
        public function moveUntilTouch(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, contact:Contact):Number
        {
            begin(agent, _bodies.ofMoving(agent), dx, dy, dz, filter);
            collect(1, Mover.TOUCH);
            var row:int = _found.first();
            var part:Number = row < 0 ? 1 : _found.limit;
            if (contact != null)
            {
                contact.time = part;
                if (row >= 0)
                {
                    var at:int = _hits.write(row, contact.point, contact.normal);
                    contact.depth = _hits.numbers[int(at + 7)];
                    contact.approachSpeed = Math.max(0, -(contact.normal.x * dx + contact.normal.y * dy + contact.normal.z * dz));
                }
            }
            if (dx != 0 || dy != 0 || dz != 0)
            {
                put(agent, _end);
            }
            return part;
        }

        /** See AgentQueries.slide. */
        public function slide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter):Number
        {
            // the agent may go anywhere within the length of its way
            begin(agent, _bodies.ofMoving(agent), dx, dy, dz, filter, Math.sqrt(dx * dx + dy * dy + dz * dz));
            mover.begin(_seen.table, body, near, 0, nearCount);
            mover.go(_way, Mover.SLIDE);
            mover.restoreClearance(true);
            if (dx != 0 || dy != 0 || dz != 0)
            {
                put(agent, mover.at);
            }
            return mover.fraction;
        }

        /** Puts an agent to its new place, and turns it by some degrees. */
        public function put(agent:Agent, at:Vector3D, turn:Number = 0):void
        {
            agent.moveTo(at.x, at.y, at.z);
            if (turn != 0)
            {
                agent.heading += turn;
            }
            if (_seen.table.rowOf(agent) >= 0)
            {
                _seen.moved(agent);
            }
        }

        /**
         * Casts an agent or a structure. See AgentQueries.castAgent and AgentQueries.castShape.
         *
         * @param agent the agent that is cast; null for a structure
         * @param body the body of the agent or of the structure
         * @param hit receives the answer; null for a new ShapeHit
         * @return hit, or the new ShapeHit; null if the way is free
         */
        public function cast(agent:Agent, body:Body, dx:Number, dy:Number, dz:Number, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            begin(agent, body, dx, dy, dz, filter);
            collect(1, Mover.SHORT);
            var row:int = _found.first();
            return row < 0 ? null : write(row, hit || new ShapeHit());
        }

        /** See AgentQueries.castAgentAll and AgentQueries.castShapeAll. The parameters are those of <code>cast()</code>. */
        public function castAll(agent:Agent, body:Body, dx:Number, dy:Number, dz:Number, filter:AgentFilter, out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            begin(agent, body, dx, dy, dz, filter);
            collect(Collector.ALL, Mover.SHORT);
            var hits:Vector.<ShapeHit> = out || new Vector.<ShapeHit>();
            var rows:Vector.<int> = _found.sorted();
            _hits.fit(hits, _found.end());
            for (var i:int = 0; i < hits.length; i++)
            {
                write(rows[i], hits[i]);
            }
            return hits;
        }

        /**
         * Finds the rows near a way.
         *
         * @param asker the agent that moves; null for a structure
         * @param asking the body that moves. It is copied, because the filter's accepts may move the agent
         * @param reach how far the body may go in any direction. If it is 0, the body goes only along the motion
         * @param up how much farther it may go upwards
         * @param down how much farther it may go downwards
         * @param turn how much greater the agent's heading will be, in degrees
         */
        public function begin(asker:Agent, asking:Body, dx:Number, dy:Number, dz:Number, filter:AgentFilter, reach:Number = 0, up:Number = 0,
                down:Number = 0, turn:Number = 0):void
        {
            requireInWorld("a motion", dx, dy, dz);
            _way.setTo(dx, dy, dz);
            if (mover == null || mover.narrowPhase !== _seen.narrowPhase)
            {
                mover = new Mover(_seen.narrowPhase);
            }
            body = asking;
            nearCount = 0;
            if (asking.shape == null)
            {
                return;
            }
            body = _copy;
            body.readShrunk(asking, null, 0);
            if (turn != 0)
            {
                body.turn(asker, turn);
            }
            _found.begin(Collector.ALL, Infinity, asker, filter);
            _seen.beginWay(_search, body);
            _search.widen(reach, up, down);
            if (reach == 0)
            {
                _search.moveAlong(dx, dy, dz, 1);
            }
            for (var row:int = _found.nextOf(_search); row >= 0; row = _found.nextOf(_search))
            {
                _found.add(row, 0);
            }
            var rows:Vector.<int> = _found.sorted();
            nearCount = _found.end();
            for (var i:int = 0; i < nearCount; i++)
            {
                near[i] = rows[i];
            }
        }

        /** Whether a row counts and is near the way of the last question. */
        public function isNear(row:int):Boolean
        {
            var i:int = 0;
            while (i < nearCount && near[i] != row)
            {
                i++;
            }
            return i < nearCount;
        }

        // Finds the rows that stop the body, each as if the others were not there. If one is wanted, the body ends at _end.
        private function collect(wanted:int, ending:int):void
        {
            var numbers:Vector.<Number> = _hits.numbers;
            var contact:ContactPoint = mover.contact;
            _end.setTo(body.placement.x, body.placement.y, body.placement.z);
            _end.incrementBy(_way);
            _found.begin(wanted, Infinity, null, null);
            for (var i:int = 0; i < nearCount && _found.limit > 0; i++)
            {
                mover.begin(_seen.table, body, near, i, i + 1);
                mover.go(_way, ending);
                if (mover.hasContact && _found.add(near[i], mover.fraction))
                {
                    var at:int = _hits.put(near[i]);
                    numbers[at] = mover.fraction;
                    numbers[int(at + 1)] = contact.x;
                    numbers[int(at + 2)] = contact.y;
                    numbers[int(at + 3)] = contact.z;
                    numbers[int(at + 4)] = contact.normalX;
                    numbers[int(at + 5)] = contact.normalY;
                    numbers[int(at + 6)] = contact.normalZ;
                    numbers[int(at + 7)] = contact.depth;
                    _end.copyFrom(mover.at);
                }
            }
        }

        // Writes how the body touches a row that stops it.
        private function write(row:int, hit:ShapeHit):ShapeHit
        {
            var at:int = _hits.write(row, hit.point, hit.normal);
            hit.agent = _seen.table.agents[row];
            hit.time = _hits.numbers[at];
            return hit;
        }
    }
}
