package starlogo.search.table
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Where the last search saw the agents of a table, and how they came there since the search before: columns by row. The extents of the shapes
     * follow the places.
     *
     * @private
     */
    public final class RowPlaces extends Points
    {
        // In place of a revision: the last search has not seen the agent. It is less than the revision of any jump.
        private static const NOT_SEEN:int = -2;

        /** The agent's revision at that place. */
        public var revisions:Vector.<int> = new Vector.<int>();

        /** The way from the place in the search before. It is 0 for an agent that has not moved, or has come without a motion. */
        public var motions:Points = new Points();

        /** Whether the agent has come without a motion: it is new, has jumped, or has the shape of another model. */
        public var haveJumped:Vector.<Boolean> = new Vector.<Boolean>();

        /** The extents of the shape at the place. */
        public var extents:Extents = new Extents();

        /** The rows that the last search has read again, because their agents had changed. */
        public var changed:IntList = new IntList();

        /** The rows that the search before has read again. */
        public var previouslyChanged:IntList = new IntList();

        // The way from the agent's place to the middle of its extents.
        private var _offsets:Points = new Points();

        /** @inheritDoc */
        override public function grow(length:int):void
        {
            super.grow(length);
            revisions.length = haveJumped.length = length;
            motions.grow(length);
            extents.grow(length);
            _offsets.grow(length);
        }

        /**
         * Reads the places of agents that have changed since the last search, for the next one. The agents have motions only once one of them has
         * swept.
         *
         * @param rows the rows of these agents
         * @param agents the agent of each row
         * @return a list that is no longer needed
         */
        internal function read(rows:IntList, agents:Vector.<Agent>):IntList
        {
            var spare:IntList = previouslyChanged;
            previouslyChanged = changed;
            changed = rows;
            if (Agent.haveSwept)
            {
                findMotions(agents);
            }
            readChanged(agents);
            return spare;
        }

        // Finds the motions of the rows that have changed. The rows that had changed in the search before, and not since, have none any more.
        private function findMotions(agents:Vector.<Agent>):void
        {
            for (var i:int = 0; i < previouslyChanged.count; i++)
            {
                setMotion(previouslyChanged.numbers[i], 0, 0, 0, false);
            }
            for (i = 0; i < changed.count; i++)
            {
                var row:int = changed.numbers[i];
                if (isMotionStart(row, agents[row]))
                {
                    var at:Placement = agents[row].placement;
                    setMotion(row, at.x - x[row], at.y - y[row], at.z - z[row], false);
                }
                else
                {
                    setMotion(row, 0, 0, 0, true);
                }
            }
        }

        private function setMotion(row:int, motionX:Number, motionY:Number, motionZ:Number, hasJumped:Boolean):void
        {
            motions.x[row] = motionX;
            motions.y[row] = motionY;
            motions.z[row] = motionZ;
            haveJumped[row] = hasJumped;
        }

        // Reads the places of the rows that have changed, and moves their extents.
        private function readChanged(agents:Vector.<Agent>):void
        {
            var numbers:Vector.<int> = changed.numbers;
            var seen:Vector.<int> = revisions;
            var xs:Vector.<Number> = x;
            var ys:Vector.<Number> = y;
            var zs:Vector.<Number> = z;
            var offsetX:Vector.<Number> = _offsets.x;
            var offsetY:Vector.<Number> = _offsets.y;
            var offsetZ:Vector.<Number> = _offsets.z;
            var boxes:Extents = extents;
            var middleX:Vector.<Number> = boxes.x;
            var middleY:Vector.<Number> = boxes.y;
            var middleZ:Vector.<Number> = boxes.z;
            var levelsEndSquared:Number = boxes.levelsEndSquared;
            var end:int = changed.count;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = numbers[i];
                var agent:Agent = agents[row];
                var at:Placement = agent.placement;
                seen[row] = agent.revision;
                xs[row] = at.x;
                ys[row] = at.y;
                zs[row] = at.z;
                var atX:Number = at.x + offsetX[row];
                var atY:Number = at.y + offsetY[row];
                var atZ:Number = at.z + offsetZ[row];
                middleX[row] = atX;
                middleY[row] = atY;
                middleZ[row] = atZ;
                // a new row has no level, and its extents are not known yet
                if (atX * atX + atY * atY + atZ * atZ >= levelsEndSquared && boxes.level[row] != 0)
                {
                    boxes.assignLevel(row);
                }
            }
        }

        /** Reads the place of one agent as it is now. */
        internal function readNow(row:int, agent:Agent):void
        {
            revisions[row] = agent.revision;
            moveTo(row, agent.placement.x, agent.placement.y, agent.placement.z);
        }

        /** Reads the extents of a row's body, which has another shape, turn or size than before. */
        internal function readExtents(row:int, body:Body):void
        {
            _offsets.x[row] = body.offsetX;
            _offsets.y[row] = body.offsetY;
            _offsets.z[row] = body.offsetZ;
            extents.halfX[row] = body.halfX;
            extents.halfY[row] = body.halfY;
            extents.halfZ[row] = body.halfZ;
            extents.radius[row] = body.radius;
            extents.offset[row] = body.offset;
            moveTo(row, x[row], y[row], z[row]);
            // the ground and the edges of the world are in no bins
            if (row >= ListedAgents.FIRST_LISTED)
            {
                extents.assignLevel(row);
            }
        }

        private function moveTo(row:int, toX:Number, toY:Number, toZ:Number):void
        {
            x[row] = toX;
            y[row] = toY;
            z[row] = toZ;
            extents.x[row] = toX + _offsets.x[row];
            extents.y[row] = toY + _offsets.y[row];
            extents.z[row] = toZ + _offsets.z[row];
        }

        /** Whether a motion of an agent may begin at its place: the last search has seen the agent there, and it has not jumped since. */
        public function isMotionStart(row:int, agent:Agent):Boolean
        {
            return agent.jumpRevision <= revisions[row];
        }

        /** A row's agent has another model now, so it has no motion. */
        internal function endMotion(row:int):void
        {
            setMotion(row, 0, 0, 0, true);
        }

        /** Lets no motion of a row's agent begin at its place, as if the last search had not seen it. */
        public function forget(row:int):void
        {
            revisions[row] = NOT_SEEN;
        }

        /** Lets no motion of any agent begin at its place. */
        public function forgetAll():void
        {
            for (var row:int = 0; row < revisions.length; row++)
            {
                forget(row);
            }
        }
    }
}
