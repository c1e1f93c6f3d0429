// This folder moves a body among the rows of a table. A MovingBody is what moves. Its BodyCore is the same body, smaller by a slop; CoreSweep finds what
// the core meets, so the body may touch what it stands on or runs along. OverlapRecovery frees the body at the beginning of a motion (RowOverlap,
// StartLift). Two classes make a motion of these: TouchSweep ends it in the touch of a row, for casts and moveUntilTouch; Slider ends it before the
// touch, or goes on along what the body meets (SlidePlanes). WalkMover makes a walk of slides and straight motions, and Foothold says where an agent
// stands. The other files are records. Read this file first, then TouchSweep, Slider and WalkMover.
package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.trees.Collector;
    import starlogo.queries.trees.SweptBoxSearch;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.pairs.PairTests;

    use namespace engine;

    /**
     * A body that moves, and the rows near its way. It tells whether the body or its core touches a row, at the places that a motion tries. The classes
     * that move it know rows only through it.
     *
     * @private
     */
    public final class MovingBody
    {
        // A one-way row stops the body with surfaces whose normal has at least this z: no steeper than 45 degrees, and a little for rounding.
        private static const UPWARDS:Number = Math.SQRT1_2 - 1e-9;

        /** The body where it begins: a copy, because a filter's <code>accepts</code> may move the agent. Read only. */
        public var source:Body = new Body();

        /** The rows that count and are near its way, in the order of the list. Read only. */
        public var rows:IntList = new IntList();

        /** The rows that stop the present motion: not those for which a plane stands, and no one-way rows that the body has passed. */
        public var obstacles:IntList = new IntList();

        /** Its core, and the tolerances of its present motion. Read only. */
        public var core:BodyCore;

        /** Collects the rows near its way. While it calls a filter's <code>accepts</code>, this must not find rows. Read only. */
        public var found:Collector;

        private var _seen:SeenAgents;

        // Finds the rows near its way.
        private var _search:SweptBoxSearch = new SweptBoxSearch();

        // The body at the place of its last test.
        private var _whole:Body = new Body();

        /** @param seen has the rows, and decides which of them touch */
        public function MovingBody(seen:SeenAgents)
        {
            _seen = seen;
            found = new Collector(seen);
            core = new BodyCore(source);
        }

        /**
         * Becomes the body of an agent, as it is now.
         *
         * @param turn by how many degrees it is turned
         * @return the body where it begins
         * @throws ArgumentError if the agent is null, has no place, or its model is unknown or lacks data that is needed
         */
        public function readAgent(agent:Agent, turn:Number = 0):Body
        {
            _seen.requirePlaced(agent);
            source.copyFrom(_seen.bodyOf(agent));
            if (turn != 0 && hasShape)
            {
                source.turn(agent, turn);
            }
            _whole.copyFrom(source);
            return source;
        }

        /**
         * Becomes the body of an agent that is cast. A sphere, box, capsule or hull becomes the body of a structure, so that an agent and the same
         * structure meet the same, to the last bit.
         */
        public function readCastAgent(agent:Agent):void
        {
            _seen.requirePlaced(agent);
            var body:Body = _seen.bodyOf(agent);
            if (body.shape == null || body.form >= ModelShape.TREE)
            {
                source.copyFrom(body);
            }
            else
            {
                source.readPlaced(body);
            }
            _whole.copyFrom(source);
        }

        /** Becomes the body of a structure. Throws the errors of <code>Body.readStructure()</code>. */
        public function readStructure(structure:BoundingStructure):void
        {
            source.readStructure(structure);
            _whole.copyFrom(source);
        }

        /** Whether it has a shape: false while the model of its agent is loading. */
        public function get hasShape():Boolean
        {
            return source.shape != null;
        }

        /** Its largest extent. */
        public function get extent():Number
        {
            return 2 * source.largestHalf;
        }

        /** Finds the rows near a straight motion. The asker is the agent that moves, or null. */
        public function findRowsAlong(motion:Vector3D, asker:Agent, filter:AgentFilter):void
        {
            if (beginRows())
            {
                _search.moveAlong(motion.x, motion.y, motion.z, 1);
                collectRows(asker, filter);
            }
        }

        /**
         * Finds the rows near motions that are not known yet.
         *
         * @param range how far it may go in any direction
         * @param up how much farther it may go upwards
         * @param down how much farther it may go downwards
         * @param asker the agent that moves
         */
        public function findRowsWithin(range:Number, up:Number, down:Number, asker:Agent, filter:AgentFilter):void
        {
            if (beginRows())
            {
                _search.widen(range, up, down);
                collectRows(asker, filter);
            }
        }

        // Begins without rows. Returns false if the model of the body is loading.
        private function beginRows():Boolean
        {
            rows.count = 0;
            if (hasShape)
            {
                _search.beginAround(_seen.treeOfExtents(), source);
            }
            return hasShape;
        }

        private function collectRows(asker:Agent, filter:AgentFilter):void
        {
            found.begin(Collector.ALL, 1, asker, filter);
            for (var row:int = found.nextOf(_search); row >= 0; row = found.nextOf(_search))
            {
                found.add(row, 0);
            }
            var count:int = found.end();
            for (var i:int = 0; i < count; i++)
            {
                rows.add(found.rowAt(i));
            }
        }

        /**
         * Begins a motion, with the core and the tolerances that it needs.
         *
         * @param among the rows that may be in its way. They become the obstacles
         * @return whether the motion has a length. If not, nothing stops it
         */
        public function beginMotion(among:IntList, from:Vector3D, motion:Vector3D):Boolean
        {
            obstacles.copyFrom(among);
            core.begin(_seen.table, among, from, motion);
            return motion.lengthSquared > Tolerances.VANISHING;
        }

        /** The body of a row. */
        public function bodyOf(row:int):Body
        {
            return _seen.table.bodyOf(row);
        }

        /** The agents, by row. */
        public function get agents():Vector.<Agent>
        {
            return _seen.table.list.agents;
        }

        /** The tests for two bodies: see NarrowPhase. */
        public function pairTestsFor(own:Body, other:Body):PairTests
        {
            return _seen.narrowPhase.pairTestsFor(own, other);
        }

        /** The whole body at a place. It is valid until the next call. */
        public function wholeAt(place:Vector3D):Body
        {
            _whole.moveTo(place);
            return _whole;
        }

        /** Whether the whole body touches a row when it stands at a place. */
        public function touches(row:int, place:Vector3D):Boolean
        {
            return areTouching(wholeAt(place), bodyOf(row));
        }

        /** Whether the core touches a row when the body stands at a place. The whole body is tested first, because mostly it does not touch either. */
        public function coreTouches(row:int, place:Vector3D):Boolean
        {
            return touches(row, place) && _seen.narrowPhase.areTouching(core.at(place), bodyOf(row));
        }

        /** Whether a row stops only what comes from above. See Agent.isOneWay. */
        public function isOneWay(row:int):Boolean
        {
            return agents[row].isOneWay;
        }

        /** Whether a row is one-way, and the body, which meets it with a contact, does not come from above. Then the body goes on through the row. */
        public function passes(row:int, contact:ContactPoint):Boolean
        {
            return isOneWay(row) && contact.normalZ < UPWARDS;
        }

        /** Whether the extents of a body, this or its core, come within a slop of another's on a motion that ends where it is. */
        public function isNear(moved:Body, other:Body, motion:RelativeMotion):Boolean
        {
            if (other.form == ModelShape.GROUND)
            {
                return true;
            }
            var slop:Number = core.slop;
            var x:Number = motion.x / 2;
            var y:Number = motion.y / 2;
            var z:Number = motion.z / 2;
            return Math.abs(moved.x - x - other.x) <= moved.halfX + other.halfX + Math.abs(x) + slop
                && Math.abs(moved.y - y - other.y) <= moved.halfY + other.halfY + Math.abs(y) + slop
                && Math.abs(moved.z - z - other.z) <= moved.halfZ + other.halfZ + Math.abs(z) + slop;
        }

        /** Whether a body, this or its core, touches another where it is. */
        public function areTouching(moved:Body, other:Body):Boolean
        {
            return isNear(moved, other, RelativeMotion.NONE) && _seen.narrowPhase.areTouching(moved, other);
        }

        /** The larger extent of the body and another. The ground's extents are those of a cell, and do not count. */
        public function extentWith(other:Body):Number
        {
            var ofOther:Number = other.form == ModelShape.GROUND ? 0 : 2 * other.largestHalf;
            return Math.max(ofOther, extent);
        }
    }
}
