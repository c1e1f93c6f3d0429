package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.search.AgentTable;

    use namespace engine;

    /**
     * Answers how far an agent or a structure can go. Some questions move the agent there. The casts move nothing.
     *
     * @private
     */
    public final class MoveQuestions
    {
        /** The motion of the next question. It is a field because V8 makes an object for each Number that is passed. */
        public var way:Vector3D = new Vector3D();

        /** Computes where moving rows end. */
        public var mover:Mover = null;

        /** The agents that count and are near the way of the last question. */
        public var agents:Vector.<Agent> = new Vector.<Agent>();

        private var _seen:SeenAgents;
        private var _single:Vector.<Agent> = new <Agent>[null];

        // The rows near the way, all with the distance 0.
        private var _search:WaySearch = new WaySearch();
        private var _found:FoundRows;

        // The structure that is cast, by the number of questions that are calling a filter's accepts.
        private var _structures:Vector.<AskedStructure> = new Vector.<AskedStructure>();

        // The hits in the order in which they are found; and by row, the number of its hit.
        private var _hits:Vector.<ShapeHit> = new Vector.<ShapeHit>();
        private var _hitOf:Vector.<int> = new Vector.<int>();

        /** @param seen the agents that questions are about */
        public function MoveQuestions(seen:SeenAgents)
        {
            _seen = seen;
            _found = new FoundRows(seen);
        }

        /**
         * Moves an agent by the motion that was set. See AgentQueries.moveUntilTouch and AgentQueries.slide.
         *
         * @param contact receives the contact; or null
         * @param slides whether the agent slides along what it meets
         * @return the free part of the motion
         */
        public function move(agent:Agent, filter:AgentFilter, contact:Contact, slides:Boolean):Number
        {
            var table:AgentTable = _seen.table;
            var row:int = begin(agent, null, filter, slides);
            var isSeen:Boolean = table.shapes[row] != null;
            if (isSeen)
            {
                mover.move(table, row, agents, way, slides ? Mover.SLIDE : Mover.TOUCH);
            }
            table.endGuests();
            if (contact != null && isSeen)
            {
                writeContact(contact);
            }
            if (way.x == 0 && way.y == 0 && way.z == 0)
            {
                return 1;
            }
            if (!isSeen)
            {
                mover.at.setTo(agent.x + way.x, agent.y + way.y, agent.z + way.z);
            }
            put(agent);
            return isSeen ? mover.part : 1;
        }

        /** Puts an agent where the mover has come to. */
        public function put(agent:Agent):void
        {
            if (mover.at.x != agent.x || mover.at.y != agent.y || mover.at.z != agent.z)
            {
                agent.moveTo(mover.at.x, mover.at.y, mover.at.z);
            }
            if (_seen.table.rowOf(agent) >= 0)
            {
                _seen.moved(agent);
            }
        }

        /**
         * Casts along the motion that was set. See AgentQueries.castShape and AgentQueries.castAgent.
         *
         * @param agent the agent that is cast, if there is no structure
         * @param structure the structure that is cast; null to cast the agent
         */
        public function cast(agent:Agent, structure:BoundingStructure, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            var row:int = begin(agent, structure, filter, false);
            var isStopped:Boolean = isStoppedBy(row, agents);
            _seen.table.endGuests();
            if (!isStopped)
            {
                return null;
            }
            hit ||= new ShapeHit();
            write(hit);
            return hit;
        }

        /** See AgentQueries.castShapeAll and AgentQueries.castAgentAll. The parameters are those of <code>cast()</code>. */
        public function castAll(agent:Agent, structure:BoundingStructure, filter:AgentFilter, out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            var row:int = begin(agent, structure, filter, false);
            _hitOf.length = Math.max(_hitOf.length, _seen.ranks.length);
            _found.begin(FoundRows.ALL, Infinity, -1, null);
            for (var i:int = 0; i < agents.length; i++)
            {
                _single[0] = agents[i];
                if (isStoppedBy(row, _single))
                {
                    addHit();
                }
            }
            _seen.table.endGuests();
            _found.sort();
            return list(out || new Vector.<ShapeHit>());
        }

        /**
         * Finds the agents near the motion that was set, and returns the row that moves. Call endGuests() of the table afterwards.
         *
         * @param isAnywhere whether the row may go that far in any direction
         */
        public function begin(agent:Agent, structure:BoundingStructure, filter:AgentFilter, isAnywhere:Boolean):int
        {
            var dx:Number = way.x;
            var dy:Number = way.y;
            var dz:Number = way.z;
            if (!isFinite(dx) || !isFinite(dy) || !isFinite(dz))
            {
                throw new RangeError("a motion must be finite: (" + dx + ", " + dy + ", " + dz + ")");
            }
            if (structure == null && agent != null && Breeds.isReserved(agent.breedNumber))
            {
                throw new ArgumentError(agent + " does not move: it stands for the ground or the edges of the world");
            }
            var asked:AskedStructure = structure == null ? null : takeStructure(structure);
            findNear(agent, asked, filter, isAnywhere);
            // the filter may have asked other questions that set the motion
            way.setTo(dx, dy, dz);
            if (mover == null || mover.pairs !== _seen.pairs)
            {
                mover = new Mover(_seen.pairs);
            }
            return readRow(agent, asked);
        }

        private function takeStructure(structure:BoundingStructure):AskedStructure
        {
            while (_seen.asking >= _structures.length)
            {
                _structures.push(new AskedStructure());
            }
            var asked:AskedStructure = _structures[_seen.asking];
            asked.setTo(structure);
            return asked;
        }

        private function readRow(agent:Agent, asked:AskedStructure):int
        {
            return asked == null ? _seen.rowOfNow(agent) : asked.readInto(_seen.table);
        }

        // Finds the agents that count and whose extents are near the way. An agent that slides may go anywhere within the length of its way, so
        // all agents within that distance are found.
        private function findNear(agent:Agent, asked:AskedStructure, filter:AgentFilter, isAnywhere:Boolean):void
        {
            var row:int = readRow(agent, asked);
            var table:AgentTable = _seen.table;
            _found.begin(FoundRows.ALL, Infinity, asked == null ? _seen.rowOf(agent) : -1, filter);
            if (table.shapes[row] != null)
            {
                _seen.beginWay(_search, row);
                if (isAnywhere)
                {
                    _search.widen(way.length);
                }
                else
                {
                    _search.moveAlong(way.x, way.y, way.z, 1);
                }
                for (var other:int = _search.next(); other >= 0; other = _search.next())
                {
                    if (_found.wants(other))
                    {
                        _found.add(other, 0);
                    }
                }
            }
            table.endGuests();
            _found.list(agents);
        }

        // Whether other agents stop a row. While a row's model is loading, none does.
        private function isStoppedBy(row:int, others:Vector.<Agent>):Boolean
        {
            if (_seen.table.shapes[row] == null)
            {
                return false;
            }
            mover.move(_seen.table, row, others, way, Mover.SHORT);
            return mover.hasContact;
        }

        private function addHit():void
        {
            var count:int = _found.count;
            if (count == _hits.length)
            {
                _hits.push(new ShapeHit());
            }
            write(_hits[count]);
            _hitOf[mover.contactRow] = count;
            _found.add(mover.contactRow, mover.part);
        }

        private function list(out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            var count:int = _found.count;
            while (out.length > count)
            {
                out.pop();
            }
            for (var i:int = 0; i < count; i++)
            {
                var hit:ShapeHit = _hits[_hitOf[_found.rows[i]]];
                if (i == out.length)
                {
                    out.push(new ShapeHit());
                }
                out[i].agent = hit.agent;
                out[i].time = hit.time;
                out[i].point.copyFrom(hit.point);
                out[i].normal.copyFrom(hit.normal);
                hit.agent = null;
            }
            return out;
        }

        // Writes how the last row that moved touches the agent that stopped it.
        private function write(hit:ShapeHit):void
        {
            var contact:ContactPoint = mover.contact;
            hit.agent = _seen.table.agents[mover.contactRow];
            hit.time = mover.part;
            hit.point.setTo(contact.x, contact.y, contact.z);
            hit.normal.setTo(contact.normalX, contact.normalY, contact.normalZ);
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
