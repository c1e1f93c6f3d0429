package starlogo.search
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.PairSink;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * What all colliders do: keeps a table of the agents, has the bins find the pairs of its rows that are near each other (thesis §3.7), and
     * the strategy decide which of them touch; standing or, where an agent sweeps, as they moved since the last search.
     *
     * <p>Questions about two agents have a table and shapes of their own, and change nothing: not what the table has yet to find void.</p>
     *
     * @private
     */
    public final class CollisionSearch extends PairSink
    {
        private var _strategy:ShapeStrategy;
        private var _bins:Bins = new Bins();
        private var _table:AgentTable;
        private var _asked:AgentTable;
        private var _pair:Vector.<Agent> = new <Agent>[null, null];
        private var _breedNumbers:BreedNumbers = new BreedNumbers();
        private var _motions:Motions = new Motions();
        private var _motionTests:MotionTests;
        private var _isSwept:Boolean = false;

        // The members of the bins: all rows, or those that take part, with the places of their agents in the list.
        private var _members:Vector.<int>;
        private var _memberCount:int = 0;
        private var _someRows:Vector.<int> = new Vector.<int>();
        private var _places:Vector.<int> = new Vector.<int>();

        // The search under way: the pairs of breeds that count, or null for all. Where an agent sweeps, the pairs that were found as numbers of
        // members, with their times. The first of a pair is the one that comes first in the list.
        private var _breeds:BreedPairs;
        private var _skippedPairs:int;
        private var _found:int;
        private var _firsts:Vector.<int> = new Vector.<int>();
        private var _seconds:Vector.<int> = new Vector.<int>();
        private var _times:Vector.<Number> = new Vector.<Number>();
        private var _order:TimeOrder = new TimeOrder();

        // Takes the agents of the pairs; and what takes the rest, if that is asked for.
        private var _out:Vector.<Agent>;
        private var _pairs:FoundPairs;
        private var _touches:RowContacts;

        /**
         * @param greatLand has the models of the agents
         * @param strategy says what stands for them
         * @throws ArgumentError if greatLand is null
         */
        public function CollisionSearch(greatLand:GreatLand, strategy:ShapeStrategy)
        {
            _strategy = strategy;
            _table = new AgentTable(strategy, new ModelShapes(greatLand, strategy), _bins);
            _asked = new AgentTable(strategy, new ModelShapes(greatLand, strategy), null);
            _motionTests = new MotionTests(strategy);
            _touches = new RowContacts(strategy, _motions, _motionTests);
        }

        /** What the last search did. */
        public function get counts():SearchCounts
        {
            return _strategy.counts;
        }

        /** Whether two agents touch where they are now, as CollisionSystem says. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            ask(a, b);
            var areTouching:Boolean = _asked.loadingCount == 0 && _strategy.areTouching(_asked, 0, 1);
            endQuestion();
            return areTouching;
        }

        /**
         * Finds the pairs that touch and whose breeds count.
         *
         * @param agents the list
         * @param breeds the pairs of breeds; null for all
         * @param out takes the agents of the pairs, in the order that FoundPairs tells
         * @throws ArgumentError as CollisionSystem.findCollisions does
         */
        public function find(agents:Vector.<Agent>, breeds:BreedPairs, out:Vector.<Agent>):void
        {
            search(agents, breeds, out, null);
            if (out.length > 2 * _found)
            {
                out.length = 2 * _found;
            }
        }

        /** As find, with the places of the agents in the list and the numbers of their breeds. */
        public function findPairs(agents:Vector.<Agent>, breeds:BreedPairs, out:FoundPairs):void
        {
            search(agents, breeds, out.agents, out);
            out.end(2 * _found);
        }

        /**
         * How two agents touch: where the last search saw them, or where they are now if it has not seen both.
         *
         * @param out takes it, the normal pointing to the first
         * @return when, on the ways of their motions
         * @throws ArgumentError if a model is unknown, or still loading
         */
        public function findContact(a:Agent, b:Agent, out:ContactPoint):Number
        {
            var rowA:int = _table.rowOf(a);
            var rowB:int = _table.rowOf(b);
            if (rowA >= 0 && rowB >= 0 && _table.shapes[rowA] != null && _table.shapes[rowB] != null)
            {
                return _touches.find(_table, rowA, rowB, _isSwept, out);
            }
            ask(a, b);
            if (_asked.loadingCount > 0)
            {
                var loading:Agent = _asked.shapes[0] == null ? a : b;
                endQuestion();
                throw new ArgumentError(loading + ": its model is still loading");
            }
            var time:Number = _touches.find(_asked, 0, 1, false, out);
            endQuestion();
            return time;
        }

        /** @inheritDoc */
        override public function onCandidates(place:int, others:Vector.<int>, count:int):void
        {
            if (_breeds != null)
            {
                var kept:int = _breedNumbers.keepCounting(_table, _bins, place, others, count);
                _skippedPairs += count - kept;
                count = kept;
            }
            if (_isSwept)
            {
                testMotions(place, others, count);
                return;
            }
            count = _strategy.keepTouching(_table, _bins, place, others, count);
            if (_pairs != null)
            {
                putNumbers(place, others, count);
            }
            var out:Vector.<Agent> = _out;
            var listed:Vector.<Agent> = _table.agents;
            var memberAt:Vector.<int> = _bins.memberAt;
            var rowAt:Vector.<int> = _bins.rowAt;
            var member:int = memberAt[place];
            var agent:Agent = listed[rowAt[place]];
            var at:int = 2 * _found;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var otherAgent:Agent = listed[rowAt[other]];
                if (member < memberAt[other])
                {
                    out[at] = agent;
                    out[at + 1] = otherAgent;
                }
                else
                {
                    out[at] = otherAgent;
                    out[at + 1] = agent;
                }
                at += 2;
            }
            _found += count;
        }

        // The places of the same agents in the list, and the numbers of their breeds.
        private function putNumbers(place:int, others:Vector.<int>, count:int):void
        {
            var places:Vector.<int> = _pairs.places;
            var breeds:Vector.<int> = _pairs.breeds;
            var numbers:Vector.<int> = _table.breeds;
            var memberAt:Vector.<int> = _bins.memberAt;
            var rowAt:Vector.<int> = _bins.rowAt;
            var hasAll:Boolean = _members === _table.rows;
            var member:int = memberAt[place];
            var breed:int = numbers[rowAt[place]];
            var at:int = 2 * _found;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = memberAt[others[i]];
                var otherBreed:int = numbers[rowAt[others[i]]];
                if (member < other)
                {
                    places[at] = member;
                    places[at + 1] = other;
                    breeds[at] = breed;
                    breeds[at + 1] = otherBreed;
                }
                else
                {
                    places[at] = other;
                    places[at + 1] = member;
                    breeds[at] = otherBreed;
                    breeds[at + 1] = breed;
                }
                if (!hasAll)
                {
                    places[at] = _places[places[at]];
                    places[at + 1] = _places[places[at + 1]];
                }
                at += 2;
            }
        }

        private function put(at:int, member:int):void
        {
            var row:int = _members[member];
            _out[at] = _table.agents[row];
            if (_pairs != null)
            {
                _pairs.places[at] = _members === _table.rows ? member : _places[member];
                _pairs.breeds[at] = _table.breeds[row];
            }
        }

        private function ask(a:Agent, b:Agent):void
        {
            _pair[0] = a;
            _pair[1] = b;
            _asked.readPair(_pair);
        }

        private function endQuestion():void
        {
            _pair[0] = _pair[1] = null;
            _asked.endPair();
        }

        private function search(agents:Vector.<Agent>, breeds:BreedPairs, out:Vector.<Agent>, pairs:FoundPairs):void
        {
            _table.read(agents);
            _out = out;
            _pairs = pairs;
            _isSwept = Agent.haveSwept && Motions.isOneSweeping(agents);
            if (_isSwept)
            {
                _motions.find(_table, _bins);
            }
            if (breeds != null)
            {
                _breedNumbers.update(_table, breeds);
            }
            chooseMembers(breeds);
            _breeds = breeds == null || breeds.areAll ? null : breeds;
            _found = _skippedPairs = 0;
            _strategy.resetCounts();
            _bins.findPairs(_isSwept ? _motions.extents : _table.extents, _members, _memberCount, this);
            if (_isSwept)
            {
                putInOrder();
            }
            _out = null;
            _pairs = null;
            _strategy.finishCounts();
            report(agents.length);
        }

        private function putInOrder():void
        {
            _order.sort(_times, _found);
            for (var i:int = 0; i < _found; i++)
            {
                var pair:int = _order.order[i];
                put(2 * i, _firsts[pair]);
                put(2 * i + 1, _seconds[pair]);
            }
        }

        // Mostly all take part.
        private function chooseMembers(breeds:BreedPairs):void
        {
            _members = _table.rows;
            _memberCount = _table.count;
            if (_table.loadingCount == 0 && (breeds == null || _breedNumbers.outsiders == 0))
            {
                return;
            }
            _members = _someRows;
            _memberCount = 0;
            for (var i:int = 0; i < _table.count; i++)
            {
                var row:int = _table.rows[i];
                if (_table.shapes[row] != null && (breeds == null || _table.breeds[row] >= 0))
                {
                    _someRows[_memberCount] = row;
                    _places[_memberCount] = i;
                    _memberCount++;
                }
            }
        }

        // Pairs of which one sweeps are tested as they moved, others where they are.
        private function testMotions(place:int, others:Vector.<int>, count:int):void
        {
            var row:int = _bins.rowAt[place];
            var member:int = _bins.memberAt[place];
            for (var i:int = 0; i < count; i++)
            {
                var otherRow:int = _bins.rowAt[others[i]];
                var other:int = _bins.memberAt[others[i]];
                // the one that comes first in the list is the one that moves
                var time:Number = member < other ? timeOf(row, otherRow) : timeOf(otherRow, row);
                if (time != RelativeMotion.NEVER)
                {
                    _firsts[_found] = Math.min(member, other);
                    _seconds[_found] = Math.max(member, other);
                    _times[_found] = time;
                    _found++;
                }
            }
        }

        private function timeOf(a:int, b:int):Number
        {
            if (_motions.isSweeping[a] || _motions.isSweeping[b])
            {
                return _motionTests.impactTime(_table, _motions, a, b, _bins.slack);
            }
            if (ShapeStrategy.areNear(_table.extents, a, b, _bins.slack) && _strategy.areTouching(_table, a, b))
            {
                return 1;
            }
            return RelativeMotion.NEVER;
        }

        private function report(agentCount:int):void
        {
            var did:SearchCounts = _strategy.counts;
            did.agents = agentCount;
            did.agentsSkipped = agentCount - _memberCount - _table.loadingCount;
            did.agentsLoading = _table.loadingCount;
            did.binEntries = _bins.entryCount;
            did.candidatePairs = _bins.pairCount - _skippedPairs;
            did.collisions = _found;
        }
    }
}
