package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * Answers questions about the agents' places: which agents are near a place, and which are the nearest.
     *
     * @private
     */
    public final class PlaceQuestions
    {
        // If too few of the nearest agents are accepted, the next search multiplies the number of agents by this.
        private static const MORE:int = 4;

        private var _seen:SeenAgents;
        private var _search:NearSearch = new NearSearch();
        private var _found:FoundRows;
        private var _cone:Cone = new Cone();
        private var _nearest:Vector.<Agent> = new Vector.<Agent>();

        /** @param seen the agents that questions are about */
        public function PlaceQuestions(seen:SeenAgents)
        {
            _seen = seen;
            _found = new FoundRows(seen);
        }

        /**
         * Lists the agents near a place.
         *
         * @param asker the agent that asks, which is left out; or null
         * @param x the place
         * @param y the place
         * @param z the place
         * @param radius the largest distance
         * @param most how many of the nearest agents are wanted, or FoundRows.ALL
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         */
        public function list(asker:Agent, x:Number, y:Number, z:Number, radius:Number, most:int, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            if (most < FoundRows.ALL && filter != null && filter.accepts != null)
            {
                return listAccepted(asker, x, y, z, radius, most, filter, out || new Vector.<Agent>());
            }
            find(asker, x, y, z, radius, most, filter);
            return _found.list(out);
        }

        /** Counts the agents near a place. The parameters are those of <code>list()</code>. */
        public function count(asker:Agent, x:Number, y:Number, z:Number, radius:Number, filter:AgentFilter):int
        {
            find(asker, x, y, z, radius, FoundRows.toFind(FoundRows.NUMBER, filter), filter);
            return _found.countAccepted(FoundRows.ALL);
        }

        /** The agent nearest to a place, or null. The parameters are those of <code>list()</code>. */
        public function nearest(asker:Agent, x:Number, y:Number, z:Number, radius:Number, filter:AgentFilter):Agent
        {
            if (filter != null && filter.accepts != null)
            {
                listAccepted(asker, x, y, z, radius, 1, filter, _nearest);
                return _nearest.length > 0 ? _nearest.pop() : null;
            }
            find(asker, x, y, z, radius, 1, filter);
            return _found.count > 0 ? _seen.table.agents[_found.rows[0]] : null;
        }

        /** See AgentQueries.inCone. */
        public function inCone(agent:Agent, radius:Number, degrees:Number, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            if (!(degrees >= 0))
            {
                throw new RangeError("degrees must not be negative: " + degrees);
            }
            var at:Placement = _seen.placeOf(agent);
            find(agent, at.x, at.y, at.z, radius, FoundRows.ALL, filter, degrees);
            return _found.list(out);
        }

        private function find(asker:Agent, x:Number, y:Number, z:Number, radius:Number, most:int, filter:AgentFilter, degrees:Number = 360):void
        {
            if (!(radius >= 0))
            {
                throw new RangeError("radius must not be negative: " + radius);
            }
            _found.begin(most, radius * radius, asker, filter);
            if (degrees < 360)
            {
                _found.cone = _cone.setTo(asker.worldPlacement(), degrees / 2, _seen.table);
            }
            _search.find(_seen.findPlaces(), x, y, z, _found);
        }

        // Calls accepts for some of the nearest agents, then for the next nearest, until enough are accepted. accepts may ask questions itself.
        private function listAccepted(asker:Agent, x:Number, y:Number, z:Number, radius:Number, most:int, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            var kept:int = 0;
            var asked:int = 0;
            var wanted:int = most;
            while (kept < most)
            {
                find(asker, x, y, z, radius, wanted, filter);
                _found.sort();
                var found:int = _found.count;
                var accepted:Vector.<Agent> = _found.keepAccepted(asked, most - kept);
                for (var i:int = 0; i < accepted.length; i++)
                {
                    out[kept] = accepted[i];
                    kept++;
                }
                if (found < wanted)
                {
                    break;
                }
                asked = found;
                wanted = MORE * wanted;
            }
            FoundRows.shorten(out, kept);
            return out;
        }
    }
}
