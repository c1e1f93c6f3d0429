package starlogo.search
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.PairSink;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * What all colliders do: keeps a table of the agents, has the bins find the pairs of its rows that are near each other (thesis §3.7), and
     * RowPairs decide which of them touch; standing or, where an agent sweeps, as they moved since the last search.
     *
     * <p>In questions about two agents these are guests of the table. They change nothing that a search keeps.</p>
     *
     * @private
     */
    public final class CollisionSearch extends PairSink
    {
        private var _pairs:RowPairs;
        private var _shapes:ModelShapes;
        private var _bins:Bins = new Bins();
        private var _table:AgentTable;
        private var _motions:Motions;
        private var _isSwept:Boolean = false;
        private var _areSpheres:Boolean = false;

        // The rows of the bins' members: all rows, or those whose breeds are of interest, with the indices of their agents in the list.
        private var _memberRows:Vector.<int>;
        private var _memberCount:int = 0;
        private var _someRows:Vector.<int> = new Vector.<int>();
        private var _indices:Vector.<int> = new Vector.<int>();

        // The search under way: the pairs of breeds of interest, or null for all; the pairs that were found, as agents, or as members' numbers
        // where these are needed; where an agent sweeps, with their times. The agents of a pair are in the order of the list.
        private var _breeds:BreedPairs;
        private var _out:Vector.<Agent>;
        private var _withNumbers:Boolean;
        private var _skippedPairs:int;
        private var _found:Vector.<int> = new Vector.<int>();
        private var _pairCount:int;
        private var _times:Vector.<Number> = new Vector.<Number>();
        private var _order:TimeOrder = new TimeOrder();

        /**
         * @param choice finds the shapes of agents
         * @param pairs decide which of them touch
         */
        public function CollisionSearch(choice:ShapeChoice, pairs:RowPairs)
        {
            _pairs = pairs;
            _shapes = new ModelShapes(choice);
            _table = new AgentTable(_shapes, _bins);
            _motions = new Motions(pairs);
        }

        /** What the last search did. */
        public function get counts():SearchCounts
        {
            return _pairs.counts;
        }

        /** Whether two agents touch where they are now, as CollisionSystem says. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            readGuests(a, b);
            var shapes:Vector.<ModelShape> = _table.shapes;
            var areTouching:Boolean = shapes[0] != null && shapes[1] != null && _pairs.areTouching(_table, 0, 1);
            _table.endGuests();
            return areTouching;
        }

        /**
         * Finds the pairs that touch and whose breeds are of interest.
         *
         * @param agents the list
         * @param breeds the pairs of breeds; null for all
         * @param out takes the agents of the pairs, in the order that FoundPairs tells
         * @throws ArgumentError as CollisionSystem.findCollisions does
         */
        public function find(agents:Vector.<Agent>, breeds:BreedPairs, out:Vector.<Agent>):void
        {
            search(agents, breeds, null, out, false);
            if (out.length > 2 * _pairCount)
            {
                out.length = 2 * _pairCount;
            }
        }

        /**
         * As find, with the indices of the agents in the list.
         *
         * @param takePart which agents do, by their indices in the list; null for all
         */
        public function findPairs(agents:Vector.<Agent>, breeds:BreedPairs, takePart:Vector.<Boolean>, out:FoundPairs):void
        {
            search(agents, breeds, takePart, out.agents, true);
            writeIndices(out.places);
            out.end(2 * _pairCount);
        }

        /** Whether the last search has seen just these agents, in this order. */
        public function isListed(agents:Vector.<Agent>):Boolean
        {
            return _table.isListed(agents);
        }

        /** As AgentTable.check. */
        public function check(agents:Vector.<Agent>):void
        {
            _table.check(agents);
        }

        /** As AgentTable.writePositions. */
        public function writePositions(bytes:ByteArray, keepsMotions:Boolean):Vector.<int>
        {
            return _table.writePositions(bytes, keepsMotions);
        }

        /** As AgentTable.restorePositions. */
        public function restorePositions(agents:Vector.<Agent>, bytes:ByteArray):void
        {
            _table.restorePositions(agents, bytes);
            _isSwept = false;
        }

        /** The row of an agent that was in the last search, or -1. */
        public function rowOf(agent:Agent):int
        {
            return _table.rowOf(agent);
        }

        /**
         * How two agents touch: where the last search saw them, or where they are now if it has not seen both.
         *
         * @param out takes it, the normal pointing to the first
         * @return when, as the two moved
         * @throws ArgumentError if a model is unknown, or still loading
         */
        public function findContact(a:Agent, b:Agent, out:ContactPoint):Number
        {
            var rowA:int = _table.rowOf(a);
            var rowB:int = _table.rowOf(b);
            if (rowA >= 0 && rowB >= 0 && _table.shapes[rowA] != null && _table.shapes[rowB] != null)
            {
                return _motions.findContact(_table, rowA, rowB, _isSwept, out);
            }
            readGuests(a, b);
            var loading:Agent = _table.shapes[0] == null ? a : b;
            if (_table.shapes[0] == null || _table.shapes[1] == null)
            {
                _table.endGuests();
                throw new ArgumentError(loading + ": its model is still loading");
            }
            var time:Number = _motions.findContact(_table, 0, 1, false, out);
            _table.endGuests();
            return time;
        }

        private function readGuests(a:Agent, b:Agent):void
        {
            _table.readGuest(0, a);
            _table.readGuest(1, b);
        }

        /** @inheritDoc */
        override public function onCandidates(slot:int, others:Vector.<int>, count:int):void
        {
            if (_breeds != null)
            {
                var kept:int = _breeds.keepOfInterest(_bins, slot, others, count);
                _skippedPairs += count - kept;
                count = kept;
            }
            if (_isSwept)
            {
                count = keepTouchingMotions(slot, others, count);
            }
            else if (_areSpheres)
            {
                count = _pairs.keepTouchingSpheres(_table, _bins, slot, others, count);
            }
            else
            {
                count = _pairs.keepTouching(_table, _bins, slot, others, count);
            }
            if (_isSwept || _withNumbers)
            {
                putMembers(slot, others, count);
            }
            if (!_isSwept)
            {
                putAgents(slot, others, count);
            }
            _pairCount += count;
        }

        // The pairs of a member and others, as numbers of members.
        private function putMembers(slot:int, others:Vector.<int>, count:int):void
        {
            var pairs:Vector.<int> = _found;
            var memberAt:Vector.<int> = _bins.memberAt;
            var member:int = memberAt[slot];
            var at:int = 2 * _pairCount;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = memberAt[others[i]];
                if (member < other)
                {
                    pairs[at] = member;
                    pairs[at + 1] = other;
                }
                else
                {
                    pairs[at] = other;
                    pairs[at + 1] = member;
                }
                at += 2;
            }
        }

        // The same pairs as agents.
        private function putAgents(slot:int, others:Vector.<int>, count:int):void
        {
            var out:Vector.<Agent> = _out;
            var listed:Vector.<Agent> = _table.agents;
            var memberAt:Vector.<int> = _bins.memberAt;
            var rowAt:Vector.<int> = _bins.rowAt;
            var member:int = memberAt[slot];
            var agent:Agent = listed[rowAt[slot]];
            var at:int = 2 * _pairCount;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                if (member < memberAt[other])
                {
                    out[at] = agent;
                    out[at + 1] = listed[rowAt[other]];
                }
                else
                {
                    out[at] = listed[rowAt[other]];
                    out[at + 1] = agent;
                }
                at += 2;
            }
        }

        private function search(agents:Vector.<Agent>, breeds:BreedPairs, takePart:Vector.<Boolean>, out:Vector.<Agent>,
                withNumbers:Boolean):void
        {
            _table.read(agents);
            _out = out;
            _withNumbers = withNumbers;
            _areSpheres = _shapes.forms == 1 << BoundingStructure.SPHERE;
            _isSwept = Agent.haveSwept && Motions.isOneSweeping(agents);
            if (_isSwept)
            {
                _motions.find(_table, _bins);
            }
            chooseMembers(breeds, takePart);
            _breeds = breeds == null || breeds.areAll ? null : breeds;
            _pairCount = _skippedPairs = 0;
            _pairs.resetCounts();
            _bins.findPairs(_isSwept ? _motions.extents : _table.extents, _memberRows, _memberCount, this);
            if (_isSwept)
            {
                _order.sort(_times, _found, _pairCount);
                writeAgents(out);
            }
            _out = null;
            _pairs.finishCounts();
            report(agents.length);
        }

        // Mostly all agents take part.
        private function chooseMembers(breeds:BreedPairs, takePart:Vector.<Boolean>):void
        {
            _memberRows = _table.rows;
            _memberCount = _table.count;
            var outsiders:int = breeds == null ? 0 : breeds.read(_table);
            if (_table.loadingCount == 0 && takePart == null && outsiders == 0)
            {
                return;
            }
            _memberRows = _someRows;
            _memberCount = 0;
            for (var i:int = 0; i < _table.count; i++)
            {
                var row:int = _table.rows[i];
                if (_table.shapes[row] != null && (outsiders == 0 || breeds.hasBreedOf(row)) && (takePart == null || takePart[i]))
                {
                    _someRows[_memberCount] = row;
                    _indices[_memberCount] = i;
                    _memberCount++;
                }
            }
        }

        // As keepTouching, with the times: pairs of which one sweeps are tested as they moved, others where they are.
        private function keepTouchingMotions(slot:int, others:Vector.<int>, count:int):int
        {
            var row:int = _bins.rowAt[slot];
            var member:int = _bins.memberAt[slot];
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var otherRow:int = _bins.rowAt[other];
                // the motion is that of the agent that is first in the list
                var isFirst:Boolean = member < _bins.memberAt[other];
                var time:Number = isFirst ? impactTime(row, otherRow) : impactTime(otherRow, row);
                if (time != RelativeMotion.NEVER)
                {
                    others[kept] = other;
                    _times[_pairCount + kept] = time;
                    kept++;
                }
            }
            return kept;
        }

        private function impactTime(a:int, b:int):Number
        {
            if (_motions.isSweeping[a] || _motions.isSweeping[b])
            {
                _motions.findTime(_table, _bins, a, b);
                return _motions.foundTime;
            }
            var areTouching:Boolean = RowPairs.areNear(_table.extents, _bins, a, b) && _pairs.areTouching(_table, a, b);
            return areTouching ? 1 : RelativeMotion.NEVER;
        }

        private function writeAgents(out:Vector.<Agent>):void
        {
            var listed:Vector.<Agent> = _table.agents;
            var members:Vector.<int> = _memberRows;
            var pairs:Vector.<int> = _found;
            var length:int = 2 * _pairCount;
            for (var i:int = 0; i < length; i++)
            {
                out[i] = listed[members[pairs[i]]];
            }
        }

        private function writeIndices(indices:Vector.<int>):void
        {
            var pairs:Vector.<int> = _found;
            var hasAll:Boolean = _memberRows === _table.rows;
            var length:int = 2 * _pairCount;
            for (var i:int = 0; i < length; i++)
            {
                var member:int = pairs[i];
                if (!hasAll)
                {
                    member = _indices[member];
                }
                indices[i] = member;
            }
        }

        private function report(agentCount:int):void
        {
            var did:SearchCounts = _pairs.counts;
            did.agents = agentCount;
            did.agentsSkipped = agentCount - _memberCount - _table.loadingCount;
            did.agentsLoading = _table.loadingCount;
            did.binEntries = _bins.entryCount;
            did.candidatePairs = _bins.pairCount - _skippedPairs;
            did.collisions = _pairCount;
        }
    }
}
