package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.boxes.AxisMotion;
    import starlogo.intersection.boxes.ContactInterval;
    import starlogo.search.pairs.PairTests;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * Finds when two rows of a table touch on their motions since the search before. It is used only if an agent sweeps. Then the motions of all rows
     * count, because a sweeping agent may meet any other one on its way. Two that do not sweep are tested where they are.
     */
    internal final class RowMotions
    {
        /** In place of a level: the extents of a row say nothing, so they rule no pair out. */
        internal static const NO_EXTENTS:BinLevel = new BinLevel(Infinity);

        /** Whether an agent of the search sweeps. If none does, the motions do not count. */
        internal var areSwept:Boolean = false;

        /** By row: the way from the place in the search before. It is 0 for an agent that has not moved, or has come without a motion. */
        internal var motions:Points = new Points();

        /** By row: whether the agent has come without a motion: it is new, has jumped, or has the shape of another model. */
        internal var haveJumped:Vector.<Boolean> = new Vector.<Boolean>();

        /** By row: the extents of the whole motion, if an agent of the search sweeps. Read only. */
        internal var extents:Extents = new Extents();

        /** The rows whose motions the search before has noted. */
        internal var previouslyChanged:IntList = new IntList();

        /** The number of pairs that the search has tested along their motions. Read only. */
        internal var sweptPairs:int = 0;

        // The rows whose motions this search has noted.
        private var _changed:IntList = new IntList();

        // By row: whether the agent sweeps, and has not come without a motion. The ground and the edges of the world do neither.
        private var _sweeps:Vector.<Boolean> = new Vector.<Boolean>();

        private var _table:AgentTable;
        private var _narrowPhase:NarrowPhase;

        // The motion of a pair that is tested.
        private var _motion:RelativeMotion = new RelativeMotion();

        // When the extents of a pair overlap.
        private var _interval:ContactInterval = new ContactInterval();
        private var _axisMotion:AxisMotion = new AxisMotion();

        /**
         * @param table has the rows
         * @param narrowPhase tests their bodies
         */
        public function RowMotions(table:AgentTable, narrowPhase:NarrowPhase)
        {
            _table = table;
            _narrowPhase = narrowPhase;
        }

        /**
         * Notes the motions of the rows that have changed. Call it in each search once an agent has swept, after the table has found the rows, and
         * before it reads their places.
         */
        public function note():void
        {
            if (_table.list.agents.length > _sweeps.length)
            {
                _sweeps.length = haveJumped.length = _table.list.agents.length;
                motions.grow(_sweeps.length);
                extents.grow(_sweeps.length);
            }
            var before:IntList = previouslyChanged;
            previouslyChanged = _changed;
            _changed = before;
            _changed.copyFrom(_table.changed);
            // rows that have not changed since have no motion any more
            for (var i:int = 0; i < previouslyChanged.count; i++)
            {
                setMotion(previouslyChanged.numbers[i], 0, 0, 0);
                haveJumped[previouslyChanged.numbers[i]] = false;
            }
            for (i = 0; i < _changed.count; i++)
            {
                var row:int = _changed.numbers[i];
                var agent:Agent = _table.list.agents[row];
                haveJumped[row] = !_table.isMotionStart(row, agent);
                if (!haveJumped[row])
                {
                    var at:Placement = agent.placement;
                    setMotion(row, at.x - _table.places.x[row], at.y - _table.places.y[row], at.z - _table.places.z[row]);
                }
            }
        }

        private function setMotion(row:int, x:Number, y:Number, z:Number):void
        {
            motions.x[row] = x;
            motions.y[row] = y;
            motions.z[row] = z;
        }

        /**
         * Begins the tests: finds the extents of the motions of rows, and which rows sweep. The table has just been read.
         *
         * @param rows the rows; those without a shape are left out, because they are members of no search
         */
        public function begin(rows:IntList):void
        {
            sweptPairs = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.numbers[i];
                if (_table.shapes[row] != null)
                {
                    _sweeps[row] = !haveJumped[row] && _table.list.agents[row].isSweeping;
                    findExtents(row);
                }
            }
        }

        // Finds the extents of the whole motion of a row.
        private function findExtents(row:int):void
        {
            var standing:Extents = _table.extents;
            var motionX:Number = motions.x[row];
            var motionY:Number = motions.y[row];
            var motionZ:Number = motions.z[row];
            var halfX:Number = standing.halfX[row] + Math.abs(motionX) / 2;
            var halfY:Number = standing.halfY[row] + Math.abs(motionY) / 2;
            extents.x[row] = standing.x[row] - motionX / 2;
            extents.y[row] = standing.y[row] - motionY / 2;
            extents.z[row] = standing.z[row] - motionZ / 2;
            extents.halfX[row] = halfX;
            extents.halfY[row] = halfY;
            extents.halfZ[row] = standing.halfZ[row] + Math.abs(motionZ) / 2;
            extents.radius[row] = Math.sqrt(halfX * halfX + halfY * halfY);
            extents.offset[row] = standing.offset[row];
            extents.assignLevel(row);
        }

        /**
         * Keeps the rows that touch a row on their motions, and moves them to the beginning of the list.
         *
         * @param level has the slack of the rows' extents; NO_EXTENTS for the ground and the edges. It is no Number, because V8 would make an object
         *     for each row
         * @param times receives the times of the touches
         * @return the number of rows that it keeps
         */
        public function keepTouching(row:int, others:Vector.<int>, count:int, level:BinLevel, times:Vector.<Number>):int
        {
            var ranks:Vector.<int> = _table.list.ranks;
            var rank:int = ranks[row];
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                // the time belongs to the motion of the agent that comes first in the list, relative to the other
                var isFirst:Boolean = rank < ranks[other];
                findTime(isFirst ? row : other, isFirst ? other : row, level, _motion);
                if (_motion.time != RelativeMotion.NEVER)
                {
                    others[kept] = other;
                    times[kept] = _motion.time;
                    kept++;
                }
            }
            return kept;
        }

        // Finds the time at which two rows first touch, from 0 to 1, or RelativeMotion.NEVER. If neither of the two sweeps, they are tested where they are
        // now. The motion receives the motion of the first relative to the second, with the time.
        private function findTime(a:int, b:int, level:BinLevel, motion:RelativeMotion):void
        {
            beginMotion(a, b, motion);
            if (!eitherSweeps(a, b))
            {
                var isNear:Boolean = level == NO_EXTENTS || _table.extents.areNear(a, b, level.slack);
                motion.time = isNear && areTouching(a, b) ? 1 : RelativeMotion.NEVER;
            }
            else if (motion.isStill)
            {
                motion.time = areTouching(a, b) ? timeOfStill(a) : RelativeMotion.NEVER;
            }
            else
            {
                sweep(a, b, level, motion);
            }
        }

        private function beginMotion(a:int, b:int, motion:RelativeMotion):void
        {
            motion.endAfter(motions.x[a] - motions.x[b], motions.y[a] - motions.y[b], motions.z[a] - motions.z[b]);
            motion.time = RelativeMotion.NEVER;
        }

        // The time at which two rows that touch first do, if the first does not move relative to the second: from the beginning on if they move alike,
        // and where they are if they have not moved.
        private function timeOfStill(a:int):int
        {
            return motions.x[a] != 0 || motions.y[a] != 0 || motions.z[a] != 0 ? 0 : 1;
        }

        // Whether two rows touch where they are. Only the second may be of the world.
        private function areTouching(a:int, b:int):Boolean
        {
            return _narrowPhase.areTouching(_table.bodyOf(a), _table.bodyOf(b));
        }

        /**
         * Finds the contact of two rows that touch, which separates them: on their motions if one of the two sweeps, or else where they are.
         *
         * @param b may be the ground or the edges of the world
         * @param motion receives the motion of the first relative to the second, with the time
         * @param out receives the contact at that time
         */
        public function findContact(a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            var bodyA:Body = _table.bodyOf(a);
            var bodyB:Body = _table.bodyOf(b);
            var tests:PairTests = _narrowPhase.pairTestsFor(bodyA, bodyB);
            beginMotion(a, b, motion);
            if (eitherSweeps(a, b))
            {
                if (!motion.isStill)
                {
                    tests.findFirst(bodyA, bodyB, motion, out);
                }
                else if (tests.areTouching(bodyA, bodyB))
                {
                    motion.time = timeOfStill(a);
                    tests.findContactOfParts(bodyA, bodyB, motion, out);
                }
            }
            if (motion.time == RelativeMotion.NEVER)
            {
                tests.findContact(bodyA, bodyB, motion, out);
                return;
            }
            tests.separate(bodyA, bodyB, motion, out);
            // the motion was relative to b at its present place, so the point is moved back to where b was at that time
            var back:Number = motion.time - 1;
            out.x += back * motions.x[b];
            out.y += back * motions.y[b];
            out.z += back * motions.z[b];
        }

        // Whether one of two rows sweeps, and has not come without a motion.
        private function eitherSweeps(a:int, b:int):Boolean
        {
            return _sweeps[a] || _sweeps[b];
        }

        private function sweep(a:int, b:int, level:BinLevel, motion:RelativeMotion):void
        {
            var areSpheres:Boolean = _table.shapes[a].form == BoundingStructure.SPHERE && _table.shapes[b].form == BoundingStructure.SPHERE;
            if (level != NO_EXTENTS && !areSpheres && !overlapOnMotions(_table.extents, level, a, b))
            {
                return;
            }
            sweptPairs++;
            if (areSpheres)
            {
                _narrowPhase.sphereTests.findTimeOfRows(_table, a, b, motion);
                return;
            }
            var bodyA:Body = _table.bodyOf(a);
            var bodyB:Body = _table.bodyOf(b);
            _narrowPhase.pairTestsFor(bodyA, bodyB).findFirst(bodyA, bodyB, motion, null);
        }

        // Whether the extents of two rows overlap in all directions at the same time, on their motions.
        private function overlapOnMotions(standing:Extents, level:BinLevel, a:int, b:int):Boolean
        {
            _interval.begin(1);
            _axisMotion.margin = level.slack;
            return narrow(standing.x, standing.halfX, motions.x, a, b) && narrow(standing.y, standing.halfY, motions.y, a, b)
                && narrow(standing.z, standing.halfZ, motions.z, a, b);
        }

        // Narrows the interval by one direction. It gets the places at the end of the motions, half the lengths, and the motions.
        private function narrow(at:Vector.<Number>, half:Vector.<Number>, motion:Vector.<Number>, a:int, b:int):Boolean
        {
            var speed:Number = motion[a] - motion[b];
            _axisMotion.offset = at[a] - at[b] - speed;
            _axisMotion.travel = speed;
            _axisMotion.halfExtents = half[a] + half[b];
            return _interval.narrow(_axisMotion);
        }
    }
}
