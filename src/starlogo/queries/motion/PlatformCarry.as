package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.agents.PlatformLink;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Trigonometry;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.trees.Collector;
    import starlogo.search.Body;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Carries an agent that walks by its platform: the agent that it stood on after its last walk, where linkToFloor() has noted it. The agent moves and
     * turns as the platform has done since then. Other platforms lift it: one-way rows that have risen into it.
     *
     * @private
     */
    public final class PlatformCarry
    {
        private var _seen:SeenAgents;
        private var _slider:Slider;

        // The rows without the platform, or one row alone.
        private var _rows:IntList = new IntList();

        // The way of the agent as the platform or a row sees it: where it begins, and the motion.
        private var _from:Vector3D = new Vector3D();
        private var _motion:Vector3D = new Vector3D();

        /**
         * @param seen has the rows
         * @param slider slides the agent along others
         */
        public function PlatformCarry(seen:SeenAgents, slider:Slider)
        {
            _seen = seen;
            _slider = slider;
        }

        /**
         * Finds the platform that carries an agent: it has moved since the last walk, and the options do not exclude it.
         *
         * @param walk has the options, and receives the platform's row, and how the platform carries the agent
         */
        public function find(agent:Agent, walk:WalkState):void
        {
            var link:PlatformLink = agent.platformLink;
            var row:int = link != null && walk.options.carried && link.carries(agent) ? _seen.rowOf(link.platform) : -1;
            if (row >= 0 && _seen.table.shapes[row] != null)
            {
                walk.carryTurn = findMotion(link, _seen.table.bodyOf(row), walk.carry);
                if ((walk.carryTurn != 0 || walk.carry.length > 0) && isAdmitted(row, agent, walk.options.filter))
                {
                    walk.platformRow = row;
                    return;
                }
            }
            walk.platformRow = -1;
            walk.carry.setTo(0, 0, 0);
            walk.carryTurn = 0;
        }

        // Whether the filter of an agent that walks admits a row. Its accepts is called.
        private function isAdmitted(row:int, asker:Agent, filter:AgentFilter):Boolean
        {
            var collector:Collector = _seen.beginCollecting(1, 0, asker, filter);
            if (collector.mayWant(row))
            {
                collector.add(row, 0);
            }
            return collector.end() > 0;
        }

        // Finds how a platform carries an agent to where the platform is now: the motion, which it writes, and the turn about the z axis, which it returns.
        // A platform whose rotation does not count now has not turned.
        private static function findMotion(link:PlatformLink, platform:Body, motion:Vector3D):Number
        {
            var from:Placement = link.platformPlacement;
            var now:Placement = platform.placement;
            var turned:Placement = platform.shape.ignoresRotation ? now : from;
            var offsetX:Number = link.walkerPlace.x - from.x;
            var offsetY:Number = link.walkerPlace.y - from.y;
            var offsetZ:Number = link.walkerPlace.z - from.z;
            if (from.size == now.size && turned.hasRotationOf(now))
            {
                motion.setTo(now.x - from.x, now.y - from.y, now.z - from.z);
                return 0;
            }
            // where the offset is now
            motion.setTo(offsetX, offsetY, offsetZ);
            Placement.rotateBack(turned, motion, motion);
            motion.scaleBy(now.size / from.size);
            now.rotate(motion, motion);
            motion.setTo(now.x - from.x + (motion.x - offsetX), now.y - from.y + (motion.y - offsetY), now.z - from.z + (motion.z - offsetZ));
            return Trigonometry.arctangent(now.r10 * turned.r00 + now.r11 * turned.r01 + now.r12 * turned.r02
                    - now.r00 * turned.r10 - now.r01 * turned.r11 - now.r02 * turned.r12,
                    now.r00 * turned.r00 + now.r01 * turned.r01 + now.r02 * turned.r02 + now.r10 * turned.r10 + now.r11 * turned.r11 + now.r12 * turned.r12);
        }

        /**
         * Carries the agent of a walk with its platform. The agent slides along others that are in its way, but not into the platform. The platform has
         * moved already, so only the rest of its way, which the agent misses, can lead into it.
         */
        public function carry(walk:WalkState):void
        {
            _rows.copyExcept(walk.body.rows, walk.platformRow);
            var end:MotionResult = _slider.slide(walk.body, _rows, walk.place, walk.carry);
            if (end.fraction < 1 && leadsIntoPlatform(walk, end.place))
            {
                var straight:MotionResult = _slider.moveStraight(walk.body, _rows, walk.place, walk.carry);
                if (!leadsIntoPlatform(walk, straight.place))
                {
                    end = straight;
                }
            }
            walk.place.copyFrom(end.place);
        }

        // Whether the way from where the platform would carry the agent to where the agent comes leads into the platform.
        private function leadsIntoPlatform(walk:WalkState, place:Vector3D):Boolean
        {
            _from.copyFrom(walk.place);
            _from.incrementBy(walk.carry);
            _motion.copyFrom(place);
            _motion.decrementBy(_from);
            return _slider.sweep.meets(walk.body, walk.platformRow, _from, _motion);
        }

        /** Notes which row an agent stands on where its walk has ended, or none with -1. Its next walk begins with what that has done until then. */
        public function linkToFloor(agent:Agent, row:int):void
        {
            var link:PlatformLink = agent.platformLink ||= new PlatformLink();
            link.platform = null;
            if (row >= ListedAgents.FIRST_LISTED)
            {
                var floor:Agent = _seen.table.listed.agentsByRow[row];
                var body:Body = _seen.table.bodyOf(row);
                link.setTo(agent, floor, body.placement, _seen.table.revisions[row]);
                if (body.shape.ignoresRotation)
                {
                    link.platformPlacement.copyRotation(floor.freshPlacement());
                }
            }
        }

        /** Finds how far up one-way rows lift the agent of a walk: those that it was above before they rose into it. Its platform carries it already. */
        public function findLift(walk:WalkState):Number
        {
            var lift:Number = 0;
            var rows:IntList = walk.body.rows;
            for (var i:int = 0; i < rows.count; i++)
            {
                var rise:Number = rows.values[i] == walk.platformRow ? 0 : _seen.heights.riseOf(_seen.table, rows.values[i]);
                if (rise > lift)
                {
                    // as the row sees it, the agent has come down by the rise. It is lifted to where the row stops this way down. The row does not stop it if
                    // the agent was within the row before
                    _rows.count = 0;
                    _rows.add(rows.values[i]);
                    _from.setTo(walk.place.x, walk.place.y, walk.place.z + rise);
                    _motion.setTo(0, 0, -rise);
                    var down:MotionResult = _slider.moveStraight(walk.body, _rows, _from, _motion);
                    lift = down.hasContact ? Math.max(lift, down.place.z - walk.place.z) : lift;
                }
            }
            return lift;
        }
    }
}
