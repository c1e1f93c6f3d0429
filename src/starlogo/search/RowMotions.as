package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * The motions of the rows of a table since the search before. They are used only if an agent sweeps. Then the motions of all rows count, because a
     * sweeping agent may touch any other one on its way. CandidateTests tests the rows on their motions.
     */
    internal final class RowMotions
    {
        /** Whether an agent of the search sweeps. If none does, the motions do not count. Read only. */
        internal var anySweeps:Boolean = false;

        /** By row: the way from the place in the search before. It is 0 for an agent that has not moved, or has no motion. */
        internal var displacements:Points = new Points();

        /**
         * By row: whether the agent sweeps on its motion. It has none if it is new, has jumped, or has the shape of another model. The ground and the
         * edges of the world do not sweep.
         */
        internal var areSweeping:Vector.<Boolean> = new Vector.<Boolean>();

        /**
         * The rows whose pairs this search can't keep, because they belong to motions of the search before. They are all rows if an agent sweeps in only
         * one of the two searches. Read only.
         */
        internal var rowsToRetest:IntList = new IntList();

        // The rows whose motions this search has read.
        private var _changed:IntList = new IntList();

        // By row: the extents of the whole motion, if an agent of the search sweeps.
        private var _sweptExtents:Extents = new Extents();

        private var _table:AgentTable;

        /** @param table has the rows */
        public function RowMotions(table:AgentTable)
        {
            _table = table;
            _sweptExtents.offsets = table.extents.offsets;
        }

        /**
         * Reads the motions of the rows that have changed, if an agent of the search sweeps. Call it after the table has taken the list, and before it reads
         * the places.
         */
        public function read():void
        {
            rowsToRetest.count = 0;
            if (anySweeps != _table.changes.anySweeps)
            {
                rowsToRetest.copyFrom(_table.listed.rows);
            }
            else if (anySweeps)
            {
                rowsToRetest.copyFrom(_changed);
            }
            anySweeps = _table.changes.anySweeps;
            if (anySweeps)
            {
                makeRoom(_table.listed.rowCapacity);
                _changed.copyFrom(_table.changes.rows);
                // rows that have not changed since stand still
                readMotions(rowsToRetest);
                readMotions(_changed);
            }
        }

        private function makeRoom(length:int):void
        {
            if (length > areSweeping.length)
            {
                areSweeping.length = length;
                displacements.grow(length);
                _sweptExtents.grow(length);
            }
        }

        // Reads the motions of rows. Rows whose agents have left have none.
        private function readMotions(rows:IntList):void
        {
            var from:Points = _table.places;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.values[i];
                var agent:Agent = _table.listed.agentsByRow[row];
                areSweeping[row] = false;
                displacements.x[row] = displacements.y[row] = displacements.z[row] = 0;
                if (agent != null && _table.isMotionStart(row))
                {
                    areSweeping[row] = agent.isSweeping;
                    displacements.x[row] = agent.placement.x - from.x[row];
                    displacements.y[row] = agent.placement.y - from.y[row];
                    displacements.z[row] = agent.placement.z - from.z[row];
                }
            }
        }

        /** The extents of the rows in the search: of their motions if an agent sweeps, or else where the rows are. */
        public function get searchExtents():Extents
        {
            return anySweeps ? _sweptExtents : _table.extents;
        }

        /**
         * If an agent of the search sweeps: finds the extents of the motions of rows. The table has just been read.
         *
         * @param rows the rows; those without a shape are left out, because they are members of no search
         */
        public function findExtents(rows:IntList):void
        {
            var standing:Extents = _table.extents;
            var swept:Extents = _sweptExtents;
            for (var i:int = 0; anySweeps && i < rows.count; i++)
            {
                var row:int = rows.values[i];
                if (_table.shapes[row] == null)
                {
                    continue;
                }
                var motionX:Number = displacements.x[row];
                var motionY:Number = displacements.y[row];
                var motionZ:Number = displacements.z[row];
                var halfX:Number = standing.halfX[row] + Math.abs(motionX) / 2;
                var halfY:Number = standing.halfY[row] + Math.abs(motionY) / 2;
                swept.x[row] = standing.x[row] - motionX / 2;
                swept.y[row] = standing.y[row] - motionY / 2;
                swept.z[row] = standing.z[row] - motionZ / 2;
                swept.halfX[row] = halfX;
                swept.halfY[row] = halfY;
                swept.halfZ[row] = standing.halfZ[row] + Math.abs(motionZ) / 2;
                swept.radiusXY[row] = Math.sqrt(halfX * halfX + halfY * halfY);
                swept.assignLevel(row);
            }
        }

        /**
         * Sets a motion to that of a row relative to another.
         *
         * @param motion gets the time NEVER
         */
        public function setRelativeMotion(a:int, b:int, motion:RelativeMotion):void
        {
            var all:Points = displacements;
            motion.endAfter(all.x[a] - all.x[b], all.y[a] - all.y[b], all.z[a] - all.z[b]);
            motion.time = RelativeMotion.NEVER;
        }

        /**
         * The time at which two rows that touch first do, if the first does not move relative to the second: from the beginning on if they move alike,
         * and where they are if they have not moved.
         */
        public function timeOfCommonMotion(a:int):int
        {
            return displacements.x[a] != 0 || displacements.y[a] != 0 || displacements.z[a] != 0 ? 0 : 1;
        }

        /** Whether one of two rows sweeps on its motion. */
        public function eitherSweeps(a:int, b:int):Boolean
        {
            return areSweeping[a] || areSweeping[b];
        }
    }
}
