package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * How the agents of a table have moved between the last two searches, for searches in which an agent sweeps: the motion of each row with its
     * extents; when two rows touch as they move, and how.
     */
    internal final class Motions
    {
        // By row: the motion, 0 where there is none; whether the agent sweeps, and has a motion; the extents of the motion, its ends included.
        internal var x:Vector.<Number> = new Vector.<Number>();
        internal var y:Vector.<Number> = new Vector.<Number>();
        internal var z:Vector.<Number> = new Vector.<Number>();
        internal var isSweeping:Vector.<Boolean> = new Vector.<Boolean>();
        internal var extents:Extents = new Extents();

        // How far the first of the last pair whose contact was found moved against the normal.
        internal var approachSpeed:Number = 0;

        private var _pairs:RowPairs;

        // Of the first of a pair relative to the second.
        private var _motion:RelativeMotion = new RelativeMotion();

        // When the extents of a pair begin and cease to overlap in the directions that were looked at so far.
        private var _enters:Number;
        private var _leaves:Number;

        private var _separation:Separation;

        /**
         * @param pairs decide which rows touch
         */
        public function Motions(pairs:RowPairs)
        {
            _pairs = pairs;
            _separation = new Separation(pairs);
        }

        /** Whether any agent of a list sweeps. */
        public static function isOneSweeping(agents:Vector.<Agent>):Boolean
        {
            for (var i:int = agents.length - 1; i >= 0; i--)
            {
                if (agents[i].isSweeping)
                {
                    return true;
                }
            }
            return false;
        }

        /** Finds the motions of a table that has just been read. */
        public function find(table:AgentTable, bins:Bins):void
        {
            makeRows(table.agents.length);
            var standing:Extents = table.extents;
            var swept:Extents = extents;
            for (var i:int = 0; i < table.count; i++)
            {
                var row:int = table.rows[i];
                var hasMotion:Boolean = table.hasMotion(row);
                var motionX:Number = hasMotion ? table.x[row] - table.lastX[row] : 0;
                var motionY:Number = hasMotion ? table.y[row] - table.lastY[row] : 0;
                var motionZ:Number = hasMotion ? table.z[row] - table.lastZ[row] : 0;
                var halfX:Number = standing.halfX[row] + Math.abs(motionX) / 2;
                var halfY:Number = standing.halfY[row] + Math.abs(motionY) / 2;
                isSweeping[row] = hasMotion && table.agents[row].isSweeping;
                x[row] = motionX;
                y[row] = motionY;
                z[row] = motionZ;
                swept.x[row] = standing.x[row] - motionX / 2;
                swept.y[row] = standing.y[row] - motionY / 2;
                swept.z[row] = standing.z[row] - motionZ / 2;
                swept.halfX[row] = halfX;
                swept.halfY[row] = halfY;
                swept.halfZ[row] = standing.halfZ[row] + Math.abs(motionZ) / 2;
                swept.radius[row] = Math.sqrt(halfX * halfX + halfY * halfY);
                if (table.shapes[row] != null)
                {
                    bins.levels.fit(swept, row);
                }
            }
        }

        /**
         * Finds when two rows of which one sweeps touch for the first time: the motion's time.
         *
         * @param bins know how far apart the extents of rows that touch may be; null to test all exactly
         */
        public function findTime(table:AgentTable, bins:Bins, a:int, b:int):void
        {
            var motion:RelativeMotion = _motion;
            motion.endAfter(x[a] - x[b], y[a] - y[b], z[a] - z[b]);
            var isStill:Boolean = motion.x == 0 && motion.y == 0 && motion.z == 0;
            var areSpheres:Boolean = RowPairs.areSpheres(table, a, b);
            if (!isStill && !areSpheres && bins != null && passEachOther(table.extents, a, b, bins.slack))
            {
                motion.time = RelativeMotion.NEVER;
                return;
            }
            _pairs.sweptPairs++;
            if (!isStill)
            {
                _pairs.findTime(table, a, b, motion);
            }
            else if (_pairs.areTouching(table, a, b))
            {
                motion.time = 0;
            }
            else
            {
                motion.time = RelativeMotion.NEVER;
            }
        }

        /** When the rows touch that findTime was asked about, from 0 to 1, or RelativeMotion.NEVER. */
        public function get foundTime():Number
        {
            return _motion.time;
        }

        /**
         * Finds how two rows touch.
         *
         * @param isSwept whether the motions are those of the table
         * @param out takes it, the normal pointing from b to a
         * @return when, as the agents move; 1 where neither sweeps
         */
        public function findContact(table:AgentTable, a:int, b:int, isSwept:Boolean, out:ContactPoint):Number
        {
            if (table.forms[a] == ModelShape.GROUND)
            {
                // the other one is moved
                var ofOther:Number = findContact(table, b, a, isSwept, out);
                out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
                return ofOther;
            }
            var motion:RelativeMotion = _motion;
            var isPassing:Boolean = isSwept && (isSweeping[a] || isSweeping[b]);
            if (isPassing)
            {
                findTime(table, null, a, b);
                isPassing = motion.time != RelativeMotion.NEVER;
            }
            if (!isPassing)
            {
                motion.endAfter(0, 0, 0);
                motion.time = 1;
            }
            var time:Number = motion.time;
            _pairs.findContact(table, a, b, motion, out);
            _separation.find(table, a, b, motion, out);
            approachSpeed = Math.max(0, -(motion.x * out.normalX + motion.y * out.normalY + motion.z * out.normalZ));
            if (isPassing)
            {
                // from where b is now to where it was
                out.x -= (1 - time) * x[b];
                out.y -= (1 - time) * y[b];
                out.z -= (1 - time) * z[b];
            }
            return time;
        }

        private function makeRows(length:int):void
        {
            if (length > x.length)
            {
                x.length = y.length = z.length = isSweeping.length = length;
                extents.grow(length);
            }
            // the ground stands
            x[RowList.GROUND] = y[RowList.GROUND] = z[RowList.GROUND] = 0;
            isSweeping[RowList.GROUND] = false;
        }

        // Whether the extents of two rows, which now are where they are at the end of the motion, never overlap in all directions at once.
        private function passEachOther(standing:Extents, a:int, b:int, slack:Number):Boolean
        {
            _enters = 0;
            _leaves = 1;
            return isGap(standing.x[b] - standing.x[a], _motion.x, standing.halfX[a] + standing.halfX[b] + slack)
                || isGap(standing.y[b] - standing.y[a], _motion.y, standing.halfY[a] + standing.halfY[b] + slack)
                || isGap(standing.z[b] - standing.z[a], _motion.z, standing.halfZ[a] + standing.halfZ[b] + slack);
        }

        // One direction: where b is from a at the end, and how far it has come down.
        private function isGap(at:Number, speed:Number, reach:Number):Boolean
        {
            at += speed;
            if (speed < 0)
            {
                speed = -speed;
                at = -at;
            }
            if (at < -reach || at - reach > _leaves * speed)
            {
                return true;
            }
            if (at > reach)
            {
                var enters:Number = (at - reach) / speed;
                if (enters > _enters)
                {
                    _enters = enters;
                }
            }
            if (at + reach < _leaves * speed)
            {
                _leaves = (at + reach) / speed;
            }
            return _enters > _leaves;
        }
    }
}
