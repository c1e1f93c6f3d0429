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
     * <p>It begins with a push along the given normal. If the two still touch after a push, their contact there is added, and the next push is
     * the shortest one out of all contacts so far (LeastPush). So a box in a corner of floor and wall goes out of both at once. No way out
     * is shorter than the overlap of two of their parts. If the push is about as short as that, it is taken. Otherwise other ways begin with
     * other contacts (<code>PairTests.findWay()</code>), and the shortest is taken.</p>
     *
     * <p>If no push is found, it tries places farther and farther away along the shortest way out of the structures around both rows. Then it
     * sweeps back to the place where the two part. The surfaces have a normal at that place. Along this normal the way out is usually shorter.
     * For convex bodies it always is, because it is at most the depth times the cosine of the angle between the two directions. So it tries
     * that normal next. It improves a direction twice at most.</p>
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

        // How many contacts a push may lead out of, how many other ways are tried, and the part of a push that must be known to be needed, so
        // that no other way is tried.
        private static const MOST_CONTACTS:int = 4;
        private static const MOST_WAYS:int = 8;
        private static const NEEDED:Number = 0.8;

        // How far a push leads into a corner of an agent at most, as a fraction of the larger extent. The cosines of the angles that the contact with
        // another side of the corner has to the push.
        private static const LARGEST_CORNER:Number = 1 / 16;
        private static const LEAST_COSINE:Number = -0.1;
        private static const MOST_COSINE:Number = 0.8;

        // How much room there is beyond a push out of several contacts, as a fraction of the larger extent. Less room is a gap between parts of the
        // second row.
        private static const ROOM:Number = 100 * Tolerances.SEPARATION;

        // How much farther than needed a push leads out of each contact, as a fraction of SEPARATION.
        private static const SLACK:Number = 0.1;

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

        // The contact with which a way begins, and the push on this way.
        private var _way:ContactPoint = new ContactPoint();
        private var _push:LeastPush = new LeastPush();

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

        // Finds the shortest way out that it can. If triangles decide and the contact is not shallow, the leaves find a direction first,
        // because their tests are fast.
        private function findLeast(motion:RelativeMotion, out:ContactPoint):void
        {
            var needed:Number = _tests.needed;
            var trees:TreePairs = _pairs.trees;
            _way.copyFrom(out);
            out.depth = Infinity;
            tryPush(out);
            if (isComing(motion) && out.depth > SHALLOW * _extent)
            {
                _way.pointAgainst(motion);
                _way.depth = 0;
                tryPush(out);
            }
            if (NEEDED * out.depth <= needed)
            {
                return;
            }
            var isExact:Boolean = trees != null && trees.exact && out.depth > SHALLOW * _extent;
            if (isExact)
            {
                trees.byLeaves = true;
            }
            tryWays(out);
            if (isExact)
            {
                trees.byLeaves = false;
                goOutAlong(out);
                refine(out);
            }
        }

        // Tries other ways than that of the first contact: straight along the shortest way out of the structures around both rows, and those that
        // begin with other contacts.
        private function tryWays(out:ContactPoint):void
        {
            _distance = 0;
            displace();
            _tests.findOuterContact(_table, _a, _b, _left);
            if (out.depth == Infinity)
            {
                goOutAlong(_left);
                refine(out);
            }
            else
            {
                point(_left);
                _free = out.depth - Tolerances.SEPARATION * _extent;
                if (!touchesFree())
                {
                    _touching = 0;
                    refine(out);
                }
            }
            for (var ways:int = 0; ways < MOST_WAYS; ways++)
            {
                _distance = 0;
                displace();
                if (!_tests.findWay(_table, _a, _b, ways == 0, GAIN * out.depth, _way))
                {
                    return;
                }
                tryPush(out);
            }
        }

        // Tries a push that begins with the contact of the way. Takes it if it is shorter than the way out so far.
        private function tryPush(out:ContactPoint):void
        {
            var slack:Number = SLACK * Tolerances.SEPARATION * _extent + _rounding;
            _push.begin();
            _push.add(_way, slack);
            for (var count:int = 1; _push.length < GAIN * out.depth; count++)
            {
                _alongX = _push.x / _push.length;
                _alongY = _push.y / _push.length;
                _alongZ = _push.z / _push.length;
                _distance = _push.length + ROOM * _extent;
                _free = _push.length + Tolerances.SEPARATION / 4 * _extent;
                if ((count == 1 || !touch()) && !touchesFree())
                {
                    takePush(out);
                    return;
                }
                if (count == MOST_CONTACTS || !findCorner())
                {
                    return;
                }
                slack *= 2;
                _push.add(_left, slack);
            }
        }

        // Finds the contact after a push, at another side of a corner. Agents that are deep in each other have many contacts in all directions,
        // or again in that of the push. Returns whether it may be a corner.
        private function findCorner():Boolean
        {
            var isGround:Boolean = _table.forms[_b] == ModelShape.GROUND;
            if (!isGround && _push.length > LARGEST_CORNER * _extent)
            {
                return false;
            }
            _tests.findContact(_table, _a, _b, RelativeMotion.NONE, _left);
            var cosine:Number = _left.normalX * _alongX + _left.normalY * _alongY + _left.normalZ * _alongZ;
            return isGround || cosine > LEAST_COSINE && cosine < MOST_COSINE;
        }

        // The two part at the end of the push, or before it.
        private function takePush(out:ContactPoint):void
        {
            out.copyFrom(_way);
            out.setNormal(_alongX, _alongY, _alongZ);
            out.depth = _push.length;
            _distance = _push.length - Tolerances.SEPARATION / 4 * _extent;
            if (_distance > 0 && !touch())
            {
                _touching = 0;
                refine(out);
            }
        }

        // Sweeps back from the free distance. If the contact is not shallow, improves the direction. Then the point becomes the middle between the
        // place where the two part and the matching place on the first row.
        private function refine(out:ContactPoint):void
        {
            sweepBack(out);
            if (out.depth > SHALLOW * _extent)
            {
                for (var left:int = IMPROVEMENTS; left > 0 && isShorterAlongLeft(out); left--)
                {
                    _touching = 0;
                    sweepBack(out);
                }
                out.x = _left.x - out.depth / 2 * out.normalX;
                out.y = _left.y - out.depth / 2 * out.normalY;
                out.z = _left.z - out.depth / 2 * out.normalZ;
            }
            makeSure(out);
        }

        // Tries the normal of the surfaces at the end of the way. Returns whether the way out along it is shorter.
        private function isShorterAlongLeft(out:ContactPoint):Boolean
        {
            var cosine:Number = _left.normalX * out.normalX + _left.normalY * out.normalY + _left.normalZ * out.normalZ;
            if (!(cosine > 0 && cosine < GAIN))
            {
                return false;
            }
            point(_left);
            _free = cosine * out.depth + Tolerances.SEPARATION * _extent;
            return !touchesFree();
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
                if (_distance <= 0 || touch())
                {
                    return;
                }
                _free = _distance;
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
