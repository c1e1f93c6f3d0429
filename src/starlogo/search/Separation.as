package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Finds a normal and a depth for a contact that separate its two rows. If the first row moves along the normal by the depth, no part of it
     * touches the second row any more.
     *
     * <p>For a given direction, it tries places farther and farther away until the two rows are apart. Then it sweeps back to the place where
     * they part. The surfaces have a normal at that place. Along this normal the way out is usually shorter. For convex bodies it always is,
     * because it is at most the depth times the cosine of the angle between the two directions. So it tries that normal next. It improves a
     * direction twice at most.</p>
     *
     * <p>If a contact is shallow, it keeps its normal. For other contacts the first directions are the given normal and the shortest way out of
     * the structures around both rows. So their depth is never more than the overlap of these structures.</p>
     *
     * @private
     */
    public final class Separation
    {
        // A contact is shallow if its depth is less than this fraction of the larger extent. The search for a way out also begins with steps of
        // this length.
        private static const SHALLOW:Number = 1 / 256;

        // How often a normal is improved at most. Another direction counts as better if its depth is less than GAIN times the old depth.
        private static const IMPROVEMENTS:int = 2;
        private static const GAIN:Number = 0.95;

        // If the sum of two normals is shorter than this, they are nearly opposite, and no direction is between them.
        private static const NEARLY_OPPOSITE:Number = 0.1;

        // The interval in which the two part is halved until it is shorter than this fraction of the larger extent. Then it is swept.
        private static const NARROW:Number = 1 / 16;

        // The extent of two points at the origin. It is not 0, so all steps are longer than 0.
        private static const LEAST_EXTENT:Number = 1e-100;

        // The most halvings. After 53 a Number has no more bits to halve.
        private static const MOST_STEPS:int = 60;

        private var _pairs:RowPairs;
        private var _moved:MovedRow = new MovedRow();

        // The pair under way, its tests, the place of its first row when they touch, the larger extent of the two, and the gap across which
        // they touch because their places are rounded.
        private var _table:AgentTable;
        private var _tests:PairTests;
        private var _a:int;
        private var _b:int;
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;
        private var _extent:Number = 0;
        private var _rounding:Number = 0;
        private var _place:Vector3D = new Vector3D();

        // The direction that is tried; a distance along it at which the two touch, a distance at which they do not, and the next step towards it.
        private var _alongX:Number = 0;
        private var _alongY:Number = 0;
        private var _alongZ:Number = 0;
        private var _touching:Number = 0;
        private var _free:Number = 0;
        private var _step:Number = 0;

        // How far the first row is moved along the direction. This is a field because V8 makes an object for each Number that is passed.
        private var _distance:Number = 0;

        // The sweep back, and the contact at its end.
        private var _back:RelativeMotion = new RelativeMotion();
        private var _left:ContactPoint = new ContactPoint();

        // The given contact, and the contact at the end of the best way so far.
        private var _start:ContactPoint = new ContactPoint();
        private var _parting:ContactPoint = new ContactPoint();

        /** @param pairs tests which rows touch, and when */
        public function Separation(pairs:RowPairs)
        {
            _pairs = pairs;
        }

        /**
         * Changes a contact's normal and depth so that they separate the two rows.
         *
         * @param motion the motion of the first row relative to the second, with the time at which they touch. It ends where the first row is in
         *     the table
         * @param out the contact of two parts that touch at that time
         */
        public function find(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            _tests = _pairs.testsOf(table, a, b);
            if (_tests.hasExactContact(table, a, b))
            {
                OverlapMiddle.setAlong(table, a, b, out);
                return;
            }
            begin(table, a, b, motion);
            _distance = 0;
            // only a row that moves may have been stopped just before the touch
            if (!isComing(motion) || touch())
            {
                findLeast(motion, out);
            }
            else
            {
                findTouch(motion, out);
            }
            _distance = 0;
            displace();
            OverlapMiddle.setAlong(table, a, b, out);
            OverlapMiddle.keepWithin(table.extents, a, out);
            if (table.forms[b] != ModelShape.GROUND)
            {
                OverlapMiddle.keepWithin(table.extents, b, out);
            }
            _moved.giveBack();
            _table = null;
        }

        private function begin(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            _table = table;
            _a = a;
            _b = b;
            _moved.take(table, a);
            _x = table.x[a] + (motion.startX + time * motion.x);
            _y = table.y[a] + (motion.startY + time * motion.y);
            _z = table.z[a] + (motion.startZ + time * motion.z);
            var half:Number = Math.max(table.extents.largestHalf(b), _moved.largestHalf);
            _rounding = table.marginOf(a) + table.marginOf(b);
            // two points have no extent. Then it is the gap across which they still touch
            _extent = Math.max(2 * half, Math.max(_rounding, LEAST_EXTENT));
        }

        // Handles two rows that do not touch at the time, because of rounding. The depth is 0. The normal points against the motion, unless the
        // two touch if the row moves a little against the given normal.
        private function findTouch(motion:RelativeMotion, out:ContactPoint):void
        {
            out.depth = 0;
            point(out);
            _distance = -Math.max(Tolerances.SEPARATION / 4 * _extent, _rounding);
            if (isComing(motion) && !touch())
            {
                out.pointAgainst(motion);
            }
        }

        // Whether the first row moves, and touches the second only after the motion's beginning.
        private static function isComing(motion:RelativeMotion):Boolean
        {
            return motion.time > 0 && (motion.x != 0 || motion.y != 0 || motion.z != 0);
        }

        // Finds the shortest way out that it can. If triangles decide, the leaves find a direction first, because their tests are fast.
        private function findLeast(motion:RelativeMotion, out:ContactPoint):void
        {
            var isDeep:Boolean = isDeepAlong(out);
            if (isDeep && isComing(motion))
            {
                _left.pointAgainst(motion);
                isDeep = isDeepAlong(_left);
            }
            if (isDeep && out.depth < SHALLOW * _extent && findCorner(out))
            {
                isDeep = isDeepAlong(_left);
            }
            if (isDeep)
            {
                var trees:TreePairs = _pairs.trees;
                var isExact:Boolean = trees != null && trees.exact;
                if (isExact)
                {
                    trees.byLeaves = true;
                }
                findDirection(out);
                if (isExact)
                {
                    trees.byLeaves = false;
                    goOutAlong(out);
                    sweepBack(out);
                    improve(out);
                }
                // the middle between the place where they part and the matching place on the first row
                out.x = _left.x - out.depth / 2 * out.normalX;
                out.y = _left.y - out.depth / 2 * out.normalY;
                out.z = _left.z - out.depth / 2 * out.normalZ;
            }
            else
            {
                sweepBack(out);
            }
            makeSure(out);
        }

        // The two may touch both sides of a corner, and neither of them deeply. Then the way out is between the sides. This finds a second
        // contact a short way along the direction. It writes to _left the normal half way between the two normals. Returns whether there is one.
        private function findCorner(contact:ContactPoint):Boolean
        {
            RelativeMotion.NONE.time = 0;
            _tests.findContact(_table, _a, _b, RelativeMotion.NONE, _left);
            _left.setNormal(_left.normalX + contact.normalX, _left.normalY + contact.normalY, _left.normalZ + contact.normalZ);
            _left.normalise();
            return _left.length > NEARLY_OPPOSITE;
        }

        // Whether the two still touch after a short way along a contact's normal.
        private function isDeepAlong(contact:ContactPoint):Boolean
        {
            point(contact);
            _touching = 0;
            _free = SHALLOW * _extent;
            return touchesFree();
        }

        private function findDirection(out:ContactPoint):void
        {
            _start.copyFrom(out);
            _distance = 0;
            displace();
            _tests.findOuterContact(_table, _a, _b, _left);
            goOutAlong(_left);
            sweepBack(out);
            _parting.copyFrom(_left);
            point(_start);
            _free = GAIN * out.depth;
            if (!tryUpToFree(out))
            {
                _left.copyFrom(_parting);
            }
            var left:int = IMPROVEMENTS;
            while (left > 0 && improve(out))
            {
                left--;
            }
        }

        // Tries the normal of the surfaces at the end of the way. Takes it if the way out along it is shorter. Returns whether it is.
        private function improve(out:ContactPoint):Boolean
        {
            var cosine:Number = _left.normalX * out.normalX + _left.normalY * out.normalY + _left.normalZ * out.normalZ;
            if (!(cosine > 0 && cosine < GAIN))
            {
                return false;
            }
            point(_left);
            _free = cosine * out.depth + Tolerances.SEPARATION * _extent;
            return tryUpToFree(out);
        }

        // Takes the direction if the two do not touch at the free distance along it. Returns whether it takes it.
        private function tryUpToFree(out:ContactPoint):Boolean
        {
            if (touchesFree())
            {
                return false;
            }
            _touching = 0;
            sweepBack(out);
            return true;
        }

        // Takes the direction of a contact's normal. Its depth is the first guess of the free distance.
        private function goOutAlong(contact:ContactPoint):void
        {
            point(contact);
            _free = contact.depth + Tolerances.SEPARATION * _extent;
            _step = SHALLOW * _extent;
            goOut();
        }

        // Increases the free distance by longer and longer steps, until the two do not touch there.
        private function goOut():void
        {
            _touching = 0;
            while (touchesFree() && _free < 1e300)
            {
                _touching = _free;
                _free += _step;
                _step *= 2;
            }
        }

        // Finds the place where the two part: it is between a place where they touch and a place where they do not. Its distance becomes the
        // contact's depth.
        private function sweepBack(out:ContactPoint):void
        {
            while (_free - _touching > NARROW * _extent)
            {
                halve();
            }
            _distance = _touching;
            displace();
            var way:Number = _touching - _free;
            _back.endAfter(way * _alongX, way * _alongY, way * _alongZ);
            _tests.findImpact(_table, _a, _b, _back, _left);
            var time:Number = Math.min(_back.time, 1);
            out.normalX = _alongX;
            out.normalY = _alongY;
            out.normalZ = _alongZ;
            out.depth = _free + time * way;
        }

        private function halve():void
        {
            var middle:Number = (_touching + _free) / 2;
            _distance = middle;
            if (touch())
            {
                _touching = middle;
            }
            else
            {
                _free = middle;
            }
        }

        // Makes sure, in spite of rounding, that the two do not touch a little beyond a contact's depth, and touch a little before it.
        private function makeSure(out:ContactPoint):void
        {
            var slack:Number = Tolerances.SEPARATION / 4 * _extent;
            point(out);
            _free = out.depth + slack;
            _step = slack;
            goOut();
            if (_touching == 0)
            {
                _distance = out.depth - slack;
                if (out.depth <= slack || touch())
                {
                    return;
                }
                _free = out.depth - slack;
            }
            for (var i:int = 0; i < MOST_STEPS && _free - _touching > slack; i++)
            {
                halve();
            }
            out.depth = (_free + _touching) / 2;
        }

        private function point(contact:ContactPoint):void
        {
            _alongX = contact.normalX;
            _alongY = contact.normalY;
            _alongZ = contact.normalZ;
        }

        private function touchesFree():Boolean
        {
            _distance = _free;
            return touch();
        }

        // Whether the two touch if the first one is moved along the direction by the distance.
        private function touch():Boolean
        {
            displace();
            return _tests.areTouching(_table, _a, _b);
        }

        private function displace():void
        {
            _place.setTo(_x + _distance * _alongX, _y + _distance * _alongY, _z + _distance * _alongZ);
            _moved.put(_place, 0);
        }
    }
}
