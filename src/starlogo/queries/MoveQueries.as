package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.geometry.requireInWorld;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
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

        private var _set:QuerySet;
        private var _hits:Hits;
        private var _triangle:TriangleOfHit = new TriangleOfHit();

        // The way of the question, a motion on it, and the place where the row that is met first stops the body.
        private var _way:Way = new Way();
        private var _motion:Motion = new Motion();
        private var _end:Vector3D = new Vector3D();

        // The lift out of all rows near the way, with which the body begins.
        private var _lift:StartLift = new StartLift();

        // The point of a hit, as a structure and as a body.
        private var _place:Sphere = new Sphere(new Vector3D(), 0);
        private var _point:Body = new Body();

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
            findWay(agent, _set.bodyOfMover(agent), dx, dy, dz, filter, _way);
            collect(1, _end);
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
                moveAgent(agent, _end);
            }
            return part;
        }

        /** See AgentQueries.slide. */
        public function slide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter):Number
        {
            // the agent may go anywhere within the length of its way
            findWayWithin(agent, _set.bodyOfMover(agent), dx, dy, dz, Math.sqrt(dx * dx + dy * dy + dz * dz), 0, 0, 0, filter, _way);
            mover.begin(_way.body, _way.rows);
            mover.slide(_way.from, _way.motion, SlideLimits.NONE, _motion);
            mover.restoreClearance(_motion.place, _motion.clearRow);
            if (dx != 0 || dy != 0 || dz != 0)
            {
                moveAgent(agent, _motion.place);
            }
            return _motion.fraction;
        }

        /**
         * Puts an agent to its new place, and turns it by some degrees.
         *
         * @throws ArgumentError if the filter's accepts has removed the agent's model. The agent has then not moved
         */
        public function moveAgent(agent:Agent, at:Vector3D, turn:Number = 0):void
        {
            _set.bodyOf(agent);
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
            findWay(agent, body, dx, dy, dz, filter, _way);
            collect(1, null);
            return _set.found.count == 0 ? null : write(0, hit || new ShapeHit());
        }

        /** See AgentQueries.castAgentAll and AgentQueries.castShapeAll. The parameters are those of <code>cast()</code>. */
        public function castAll(agent:Agent, body:Body, dx:Number, dy:Number, dz:Number, filter:AgentFilter, out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            findWay(agent, body, dx, dy, dz, filter, _way);
            collect(Collector.ALL, null);
            var hits:Vector.<ShapeHit> = out || new Vector.<ShapeHit>();
            _hits.fit(hits, _set.found.endSorted());
            for (var i:int = 0; i < hits.length; i++)
            {
                write(i, hits[i]);
            }
            return hits;
        }

        /**
         * Finds the rows on a straight way.
         *
         * @param asker the agent that moves; null for a structure
         * @param asking the body that moves. It is copied, because the filter's accepts may move the agent
         * @param out receives the way
         */
        public function findWay(asker:Agent, asking:Body, dx:Number, dy:Number, dz:Number, filter:AgentFilter, out:Way):void
        {
            if (beginWay(asking, dx, dy, dz, out))
            {
                _set.seen.beginWay(_set.boxSearch, out.body);
                _set.boxSearch.moveAlong(dx, dy, dz, 1);
                collectRows(asker, filter, out);
            }
        }

        /**
         * Finds the rows near a way that may turn.
         *
         * @param asker the agent that moves
         * @param asking the body that moves. It is copied, because the filter's accepts may move the agent
         * @param range how far the body may go in any direction
         * @param up how much farther it may go upwards
         * @param down how much farther it may go downwards
         * @param turn how much greater the agent's heading will be, in degrees
         * @param out receives the way
         */
        public function findWayWithin(asker:Agent, asking:Body, dx:Number, dy:Number, dz:Number, range:Number, up:Number, down:Number, turn:Number,
                filter:AgentFilter, out:Way):void
        {
            if (beginWay(asking, dx, dy, dz, out))
            {
                if (turn != 0)
                {
                    out.body.turn(asker, turn);
                }
                _set.seen.beginWay(_set.boxSearch, out.body);
                _set.boxSearch.widen(range, up, down);
                collectRows(asker, filter, out);
            }
        }

        // Begins a way without rows. Returns false if the model of the body is loading.
        private function beginWay(asking:Body, dx:Number, dy:Number, dz:Number, out:Way):Boolean
        {
            requireInWorld("a motion", dx, dy, dz);
            out.motion.setTo(dx, dy, dz);
            out.from.setTo(asking.placement.x, asking.placement.y, asking.placement.z);
            out.body = asking;
            out.rows.count = 0;
            if (asking.shape == null)
            {
                return false;
            }
            out.body = _set.second;
            out.body.readShrunk(asking, null, 0);
            return true;
        }

        private function collectRows(asker:Agent, filter:AgentFilter, out:Way):void
        {
            var found:Collector = _set.found;
            found.begin(Collector.ALL, Infinity, asker, filter);
            for (var row:int = found.nextOf(_set.boxSearch); row >= 0; row = found.nextOf(_set.boxSearch))
            {
                found.add(row, 0);
            }
            var count:int = found.endSorted();
            for (var i:int = 0; i < count; i++)
            {
                out.rows.add(found.rows[i]);
            }
        }

        // Finds the rows that stop the body, each as if the others were not there. If an end is given, it receives the place where the first of
        // them stops it.
        private function collect(wanted:int, end:Vector3D):void
        {
            _lift.clear();
            if (collectLifted(wanted, end))
            {
                // a floor may be many rows: what is lifted out of one of them does not run into the next
                mover.begin(_way.body, _way.rows);
                if (mover.findLift(_way.from, _way.motion, _motion, _lift))
                {
                    collectLifted(wanted, end);
                }
            }
        }

        // Does so with the body lifted. Returns whether a common lift of all rows could change the answer.
        private function collectLifted(wanted:int, end:Vector3D):Boolean
        {
            var rows:NumberList = _way.rows;
            var mayLift:Boolean = false;
            _set.found.begin(wanted, Infinity, null, null);
            if (end != null)
            {
                end.copyFrom(_way.from);
                end.incrementBy(_way.motion);
                _lift.keepDepth(end, _way.from.x, _way.from.y, _way.from.z);
            }
            for (var i:int = 0; i < rows.count && _set.found.limit > 0; i++)
            {
                var row:int = rows.numbers[i];
                mover.beginAgainst(_way.body, row);
                mover.findTouch(_way.from, _way.motion, _lift, _motion);
                mayLift ||= _motion.isLifted || (_motion.fraction == 0 && !_motion.isDeep);
                if (_motion.row < 0 || !_set.found.add(row, _motion.fraction))
                {
                    continue;
                }
                _hits.newContact(row).copyFrom(_motion.contact);
                if (end != null)
                {
                    mover.goIntoTouch(_motion);
                    end.copyFrom(_motion.place);
                }
            }
            return mayLift;
        }

        private function writeTriangle(row:int, hit:ShapeHit):void
        {
            var body:Body = _set.seen.table.bodyOf(row);
            hit.triangle = -1;
            if (body.form == ModelShape.TREE)
            {
                // agents at the edges of the largest world may be touched outside of it
                _place.center.setTo(inWorld(hit.point.x), inWorld(hit.point.y), inWorld(hit.point.z));
                _point.readStructure(_place);
                hit.triangle = _set.seen.narrowPhase.trees.nearestTriangle(body, _point);
            }
            var from:TriangleOfHit = _triangle;
            from.read(body, hit.triangle, hit.point, hit.weights);
            hit.mesh = from.mesh;
            hit.material = from.material;
            hit.materialName = from.materialName;
        }

        private static function inWorld(coordinate:Number):Number
        {
            return Math.max(-Agent.LARGEST_COORDINATE, Math.min(Agent.LARGEST_COORDINATE, coordinate));
        }

        // Writes how the body touches a row of the answer.
        private function write(index:int, hit:ShapeHit):ShapeHit
        {
            _hits.write(index, hit.point, hit.normal);
            hit.agent = _set.found.agentAt(index);
            hit.time = _set.found.keys[index];
            writeTriangle(_set.found.rows[index], hit);
            return hit;
        }
    }
}
