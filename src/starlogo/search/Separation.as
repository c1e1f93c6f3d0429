package starlogo.search
{
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Makes the depth of a contact separate: how far the first of two rows has to be moved along the normal until nothing of it touches the
     * second any more, however many parts of the two overlap.
     *
     * <p>Along a direction, places farther and farther out are tried until the two are apart; the sweep back from there touches where they part.
     * Where that is, the surfaces have a normal, and along it the way out is shorter than before, of convex bodies always (as the plane through the
     * point is crossed at the cosine of the angle). So the direction is improved until that ends. It begins with the normal of the contact that is
     * given, and with that axis of the world along which the extents overlap least, so that the depth is never more than that.</p>
     *
     * @private
     */
    public final class Separation
    {
        // The way out is looked for in steps from this share of the larger extent on, each twice as long; contacts less deep keep their normal.
        private static const FIRST_STEP:Number = 1 / 256;

        // How often a normal is improved, and by how much a depth has to be less for it to count.
        private static const IMPROVEMENTS:int = 3;
        private static const GAIN:Number = 0.999;

        // Halvings, of which 53 leave nothing of a Number.
        private static const MOST_STEPS:int = 60;

        private var _strategy:ShapeStrategy;
        private var _sweep:RowSweep;

        // The pair under way, where its first row is when they touch, and their larger extent.
        private var _table:AgentTable;
        private var _a:int;
        private var _b:int;
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;
        private var _extent:Number = 0;

        // The direction that is tried.
        private var _alongX:Number = 0;
        private var _alongY:Number = 0;
        private var _alongZ:Number = 0;

        // How far out the two are apart along it, and what the sweep back from there says; beyond which distance it is not of interest.
        private var _exit:Number = 0;
        private var _limit:Number = 0;
        private var _back:RelativeMotion = new RelativeMotion();
        private var _backTime:Number = 0;
        private var _backEnd:Number = 0;
        private var _left:ContactPoint = new ContactPoint();

        /**
         * @param strategy decides whether rows touch
         * @param sweep when they do as one moves
         */
        public function Separation(strategy:ShapeStrategy, sweep:RowSweep)
        {
            _strategy = strategy;
            _sweep = sweep;
        }

        /**
         * Makes a contact's normal and depth separate.
         *
         * @param motion of the first row, which ends where it is in the table, relative to the second
         * @param time when they touch
         * @param out the contact of two parts that touch then: its point stays
         */
        public function find(table:AgentTable, a:int, b:int, motion:RelativeMotion, time:Number, out:ContactPoint):void
        {
            if ((table.shapes[a].isSphere && table.shapes[b].isSphere) || _strategy.hasExactContact(table, a, b))
            {
                return;
            }
            var x:Number = table.x[a];
            var y:Number = table.y[a];
            var z:Number = table.z[a];
            var revision:int = table.revisions[a];
            begin(table, a, b, x + (motion.startX + time * motion.x), y + (motion.startY + time * motion.y), z + (motion.startZ + time * motion.z));
            if (touchAt(0))
            {
                findLeast(motion, time, out);
            }
            else
            {
                findTouch(motion, time, out);
            }
            table.putBack(a, x, y, z, revision);
            _table = null;
        }

        private function begin(table:AgentTable, a:int, b:int, x:Number, y:Number, z:Number):void
        {
            _table = table;
            _a = a;
            _b = b;
            _x = x;
            _y = y;
            _z = z;
            _extent = 2 * Math.max(longestHalf(table.extents, a), longestHalf(table.extents, b));
        }

        private static function longestHalf(extents:Extents, row:int):Number
        {
            return Math.max(extents.halfX[row], Math.max(extents.halfY[row], extents.halfZ[row]));
        }

        // Rounding has them just not touching: there is no depth, and the motion's direction is the normal unless the two touch along theirs.
        private function findTouch(motion:RelativeMotion, time:Number, out:ContactPoint):void
        {
            out.depth = 0;
            point(out.normalX, out.normalY, out.normalZ);
            if (isComing(motion, time) && !touchAt(-Tolerances.SEPARATION / 4 * _extent))
            {
                out.pointAlong(-motion.x, -motion.y, -motion.z);
            }
        }

        // Whether there was no touch before the time.
        private static function isComing(motion:RelativeMotion, time:Number):Boolean
        {
            return time > 0 && (motion.x != 0 || motion.y != 0 || motion.z != 0);
        }

        private function findLeast(motion:RelativeMotion, time:Number, out:ContactPoint):void
        {
            point(out.normalX, out.normalY, out.normalZ);
            _limit = Infinity;
            findExit(out.depth);
            out.depth = _exit;
            if (out.depth > FIRST_STEP * _extent)
            {
                tryExtents(out);
                if (isComing(motion, time))
                {
                    var length:Number = Math.sqrt(motion.x * motion.x + motion.y * motion.y + motion.z * motion.z);
                    point(-motion.x / length, -motion.y / length, -motion.z / length);
                    tryExit(0, out);
                }
                var left:int = IMPROVEMENTS;
                while (left > 0 && improve(out))
                {
                    left--;
                }
            }
            point(out.normalX, out.normalY, out.normalZ);
            _exit = out.depth;
            makeSure();
            out.depth = _exit;
        }

        // That axis along which the extents overlap least.
        private function tryExtents(out:ContactPoint):void
        {
            var extents:Extents = _table.extents;
            displace(0);
            var x:Number = extents.x[_a] - extents.x[_b];
            var y:Number = extents.y[_a] - extents.y[_b];
            var z:Number = extents.z[_a] - extents.z[_b];
            var overlapX:Number = extents.halfX[_a] + extents.halfX[_b] - Math.abs(x);
            var overlapY:Number = extents.halfY[_a] + extents.halfY[_b] - Math.abs(y);
            var overlapZ:Number = extents.halfZ[_a] + extents.halfZ[_b] - Math.abs(z);
            var least:Number = overlapX;
            point(x < 0 ? -1 : 1, 0, 0);
            if (overlapY < least)
            {
                least = overlapY;
                point(0, y < 0 ? -1 : 1, 0);
            }
            if (overlapZ < least)
            {
                least = overlapZ;
                point(0, 0, z < 0 ? -1 : 1);
            }
            tryExit(least, out);
        }

        // Takes the normal of the surfaces where the two part along the contact's, if that is a shorter way out. Returns whether it is.
        private function improve(out:ContactPoint):Boolean
        {
            point(out.normalX, out.normalY, out.normalZ);
            displace(_backEnd);
            _sweep.findContact(_table, _a, _b, _back, _backTime, _left);
            var cosine:Number = _left.normalX * out.normalX + _left.normalY * out.normalY + _left.normalZ * out.normalZ;
            if (!(cosine > 0 && cosine < GAIN))
            {
                return false;
            }
            point(_left.normalX, _left.normalY, _left.normalZ);
            return tryExit(cosine * out.depth, out);
        }

        // Takes a direction if it is a shorter way out.
        private function tryExit(guess:Number, out:ContactPoint):Boolean
        {
            _limit = GAIN * out.depth;
            if (!findExit(guess))
            {
                return false;
            }
            out.normalX = _alongX;
            out.normalY = _alongY;
            out.normalZ = _alongZ;
            out.depth = _exit;
            return true;
        }

        // Finds where the two part, if that is before the limit. They touch at the beginning.
        private function findExit(guess:Number):Boolean
        {
            var touching:Number = 0;
            var step:Number = FIRST_STEP * _extent;
            var free:Number = guess + Tolerances.SEPARATION * _extent;
            while (true)
            {
                if (free > _limit)
                {
                    free = _limit;
                }
                if (!touchAt(free))
                {
                    break;
                }
                if (free == _limit || !(free < 1e300))
                {
                    return false;
                }
                touching = free;
                free += step;
                step *= 2;
            }
            displace(touching);
            _backEnd = touching;
            var way:Number = touching - free;
            _back.endAfter(way * _alongX, way * _alongY, way * _alongZ);
            _backTime = _sweep.impactTime(_table, _a, _b, _back);
            if (_backTime > 1)
            {
                _backTime = 1;
            }
            _exit = free + _backTime * way;
            return true;
        }

        // Makes sure that the two are apart a little beyond the exit, and touch a little before it, in spite of rounding.
        private function makeSure():void
        {
            var slack:Number = Tolerances.SEPARATION / 4 * _extent;
            var touching:Number = 0;
            var free:Number = _exit + slack;
            if (touchAt(free))
            {
                var step:Number = slack;
                do
                {
                    touching = free;
                    free += step;
                    step *= 2;
                }
                while (touchAt(free) && free < 1e300);
            }
            else if (_exit > slack)
            {
                touching = _exit - slack;
                if (touchAt(touching))
                {
                    return;
                }
                free = touching;
                touching = 0;
            }
            else
            {
                return;
            }
            for (var i:int = 0; i < MOST_STEPS && free - touching > slack; i++)
            {
                var middle:Number = (free + touching) / 2;
                if (touchAt(middle))
                {
                    touching = middle;
                }
                else
                {
                    free = middle;
                }
            }
            _exit = (free + touching) / 2;
        }

        private function point(x:Number, y:Number, z:Number):void
        {
            _alongX = x;
            _alongY = y;
            _alongZ = z;
        }

        // Whether the two touch when the first has been moved along the direction.
        private function touchAt(distance:Number):Boolean
        {
            displace(distance);
            return _strategy.areTouching(_table, _a, _b);
        }

        private function displace(distance:Number):void
        {
            _table.displace(_a, _x + distance * _alongX, _y + distance * _alongY, _z + distance * _alongZ);
        }
    }
}
