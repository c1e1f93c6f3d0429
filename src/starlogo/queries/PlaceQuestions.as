package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * The questions about where agents are: which are near, and which is the nearest.
     *
     * @private
     */
    public final class PlaceQuestions
    {
        // How much farther, squared, those are that are asked at once after all that are nearer have been refused.
        private static const FARTHER:Number = 4;

        private var _seen:SeenAgents;
        private var _rows:FilteredRows;
        private var _answers:Answers;

        /**
         * @param seen the agents that are asked about
         * @param rows applies filters to them
         * @param answers makes the lists
         */
        public function PlaceQuestions(seen:SeenAgents, rows:FilteredRows, answers:Answers)
        {
            _seen = seen;
            _rows = rows;
            _answers = answers;
        }

        /** As AgentQueries.near. */
        public function near(agent:Agent, radius:Number, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            return list(within(_seen.placesAbout(agent), radius), filter, out);
        }

        /** As AgentQueries.nearPoint. */
        public function nearPoint(point:Vector3D, radius:Number, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            return list(within(placesAt(point), radius), filter, out);
        }

        /** As AgentQueries.countNear. */
        public function countNear(agent:Agent, radius:Number, filter:AgentFilter):int
        {
            return count(within(_seen.placesAbout(agent), radius), filter);
        }

        /** As AgentQueries.countNearPoint. */
        public function countNearPoint(point:Vector3D, radius:Number, filter:AgentFilter):int
        {
            return count(within(placesAt(point), radius), filter);
        }

        /** As AgentQueries.nearest. */
        public function nearest(agent:Agent, radius:Number, filter:AgentFilter):Agent
        {
            return find(within(_seen.placesAbout(agent), radius), filter);
        }

        /** As AgentQueries.nearestToPoint. */
        public function nearestToPoint(point:Vector3D, radius:Number, filter:AgentFilter):Agent
        {
            return find(within(placesAt(point), radius), filter);
        }

        /** As AgentQueries.inCone. */
        public function inCone(agent:Agent, radius:Number, degrees:Number, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            if (!(degrees >= 0))
            {
                throw new RangeError("degrees must not be negative: " + degrees);
            }
            var places:PlaceTree = within(_seen.placesAbout(agent), radius);
            var count:int = places.findNear(_rows.of(filter));
            if (degrees < 360)
            {
                places.coneAngle = degrees / 2;
                count = places.keepInCone(agent.worldPlacement(), count);
            }
            return _answers.list(places.found, places.squares, count, filter, out);
        }

        private function placesAt(point:Vector3D):PlaceTree
        {
            if (point == null)
            {
                throw new ArgumentError("a point is needed, not null");
            }
            if (!isFinite(point.x) || !isFinite(point.y) || !isFinite(point.z))
            {
                throw new RangeError("a point must be finite: " + point);
            }
            var places:PlaceTree = _seen.places;
            places.x = point.x;
            places.y = point.y;
            places.z = point.z;
            return places;
        }

        private static function within(places:PlaceTree, radius:Number):PlaceTree
        {
            if (!(radius >= 0))
            {
                throw new RangeError("radius must not be negative: " + radius);
            }
            places.limit = radius * radius;
            return places;
        }

        private function list(places:PlaceTree, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            var count:int = places.findNear(_rows.of(filter));
            return _answers.list(places.found, places.squares, count, filter, out);
        }

        private function count(places:PlaceTree, filter:AgentFilter):int
        {
            var test:RowTest = _rows.of(filter);
            if (filter == null || filter.accepts == null)
            {
                return places.countNear(test);
            }
            return _answers.countAccepted(places.found, places.squares, places.findNear(test), filter.accepts);
        }

        private function find(places:PlaceTree, filter:AgentFilter):Agent
        {
            var member:int = places.findNearest(_rows.of(filter));
            if (member < 0)
            {
                return null;
            }
            if (filter == null || filter.accepts == null)
            {
                return _seen.agentOf(member);
            }
            return findAccepted(places, filter, member);
        }

        // Asks of the nearest, then of those that are up to twice as far, and so on. The filter may ask questions of the same tree.
        private function findAccepted(places:PlaceTree, filter:AgentFilter, member:int):Agent
        {
            var x:Number = places.x;
            var y:Number = places.y;
            var z:Number = places.z;
            var limit:Number = places.limit;
            var skipped:int = places.skipped;
            var square:Number = places.squareOf(member);
            places.found[0] = member;
            places.squares[0] = square;
            var accepted:Agent = _answers.firstAccepted(places.found, places.squares, 0, 1, filter.accepts);
            var asked:int = 1;
            while (accepted == null)
            {
                places = _seen.places;
                places.x = x;
                places.y = y;
                places.z = z;
                places.skipped = skipped;
                places.limit = limit;
                if (FARTHER * square < limit)
                {
                    places.limit = FARTHER * square;
                }
                var found:int = places.findNear(_rows.of(filter));
                if (found > asked)
                {
                    square = places.limit;
                    accepted = _answers.firstAccepted(places.found, places.squares, asked, found, filter.accepts);
                    asked = found;
                    continue;
                }
                // the nearest of those that are beyond
                places.beyond = places.limit;
                places.limit = limit;
                member = places.findNearest(_rows.of(filter));
                places.beyond = -1;
                if (member < 0)
                {
                    break;
                }
                square = places.squareOf(member);
            }
            return accepted;
        }
    }
}
