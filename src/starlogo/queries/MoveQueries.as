package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.geometry.requireInWorld;
    import starlogo.search.Body;
    import starlogo.search.NumberList;

    use namespace engine;

    /**
     * Answers how far an agent or a structure can go. Some questions move the agent there. The casts move nothing.
     *
     * @private
     */
    public final class MoveQueries
    {
        /** Computes where moving bodies end. */
        public var mover:Mover;

        /** The body that moves, as it was at the beginning of the last question. */
        public var body:Body;

        /** The rows that count and are near the way of the last question, in the order of the list. */
        public var near:NumberList = new NumberList();

        private var _set:QuerySet;
        private var _hits:Hits;
        private var _way:Vector3D = new Vector3D();

        // The place where the row that is met first stops the body.
        private var _end:Vector3D = new Vector3D();

        // The lift out of all rows near the way, with which the body begins, and whether there may be one.
        private var _lift:StartLift = new StartLift();
        private var _mayLift:Boolean = false;

        /** @param questions what questions work with */
        public function MoveQueries(questions:QuerySet)
        {
            _set = questions;
            _hits = new Hits(questions.found, ShapeHit);
            mover = new Mover(questions.seen);
        }

        /** See AgentQueries.moveUntilTouch. */
        public function moveUntilTouch(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, contact:Contact):Number
        {
            begin(agent, _set.ofMoving(agent), dx, dy, dz, filter);
            collect(1, Mover.TOUCH);
            var isMet:Boolean = _set.found.count > 0;
            var part:Number = isMet ? _set.found.keys[0] : 1;
            if (contact != null)
            {
                contact.time = part;
                if (isMet)
                {
                    contact.depth = _hits.write(0, contact.point, contact.normal).depth;
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
            begin(agent, _set.ofMoving(agent), dx, dy, dz, filter, Math.sqrt(dx * dx + dy * dy + dz * dz));
            mover.begin(body, near.numbers, 0, near.count);
            mover.slide(_way);
            mover.restoreClearance(true);
            if (dx != 0 || dy != 0 || dz != 0)
            {
                put(agent, mover.at);
            }
            return mover.fraction;
        }

        /**
         * Puts an agent to its new place, and turns it by some degrees.
         *
         * @throws ArgumentError if the filter's accepts has removed the agent's model. The agent has then not moved
         */
        public function put(agent:Agent, at:Vector3D, turn:Number = 0):void
        {
            _set.ofAgent(agent);
            agent.moveTo(at.x, at.y, at.z);
            if (turn != 0)
            {
                agent.heading += turn;
            }
            if (_set.seen.rowOf(agent) >= 0)
            {
                _set.seen.moved(agent);
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
            return _set.found.count == 0 ? null : write(0, hit || new ShapeHit());
        }

        /** See AgentQueries.castAgentAll and AgentQueries.castShapeAll. The parameters are those of <code>cast()</code>. */
        public function castAll(agent:Agent, body:Body, dx:Number, dy:Number, dz:Number, filter:AgentFilter, out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            begin(agent, body, dx, dy, dz, filter);
            collect(Collector.ALL, Mover.SHORT);
            var hits:Vector.<ShapeHit> = out || new Vector.<ShapeHit>();
            _hits.fit(hits);
            for (var i:int = 0; i < hits.length; i++)
            {
                write(i, hits[i]);
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
            body = asking;
            near.count = 0;
            if (asking.shape == null)
            {
                return;
            }
            body = _set.second;
            body.readShrunk(asking, null, 0);
            if (turn != 0)
            {
                body.turn(asker, turn);
            }
            var found:Collector = _set.found;
            found.begin(Collector.ALL, Infinity, asker, filter);
            _set.seen.beginWay(_set.way, body);
            _set.way.widen(reach, up, down);
            if (reach == 0)
            {
                _set.way.moveAlong(dx, dy, dz, 1);
            }
            for (var row:int = found.nextOf(_set.way); row >= 0; row = found.nextOf(_set.way))
            {
                found.add(row, 0);
            }
            var count:int = found.endSorted();
            for (var i:int = 0; i < count; i++)
            {
                near.add(found.rows[i]);
            }
        }

        // Finds the rows that stop the body, each as if the others were not there. If one is wanted, the body ends at _end.
        private function collect(wanted:int, ending:int):void
        {
            _lift.clear();
            collectLifted(wanted, ending);
            if (_mayLift)
            {
                // a floor may be many rows: what is lifted out of one of them does not run into the next
                mover.begin(body, near.numbers, 0, near.count);
                if (mover.findLift(_way, _lift))
                {
                    collectLifted(wanted, ending);
                }
            }
        }

        // Does so with the body lifted, and notes whether a common lift of all rows could change the answer.
        private function collectLifted(wanted:int, ending:int):void
        {
            var rows:Vector.<int> = near.numbers;
            _mayLift = false;
            _end.setTo(body.placement.x, body.placement.y, body.placement.z);
            _end.incrementBy(_way);
            _lift.keepDepth(_end, body.placement.x, body.placement.y, body.placement.z);
            _set.found.begin(wanted, Infinity, null, null);
            for (var i:int = 0; i < near.count && _set.found.limit > 0; i++)
            {
                mover.begin(body, rows, i, i + 1);
                mover.goUntilTouch(_way, ending, _lift);
                _mayLift ||= mover.isLifted || (mover.fraction == 0 && !mover.isDeep);
                if (mover.contactRow >= 0 && _set.found.add(rows[i], mover.fraction))
                {
                    _hits.put(rows[i]).copyFrom(mover.contact);
                    _end.copyFrom(mover.at);
                }
            }
        }

        // Writes how the body touches a row of the answer.
        private function write(index:int, hit:ShapeHit):ShapeHit
        {
            _hits.write(index, hit.point, hit.normal);
            hit.agent = _set.found.agentAt(index);
            hit.time = _set.found.keys[index];
            return hit;
        }
    }
}
