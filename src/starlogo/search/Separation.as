package starlogo.search
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Finds a normal and a depth for a contact that separate its two bodies. If the first one moves along the normal by the depth, no part of it
     * touches the second one any more.
     *
     * <p>It begins with a push along the given normal. If the two still touch after a push, their contact there is added, and the next push is
     * the shortest one out of all contacts so far (PushSearch). So a box in a corner of floor and wall goes out of both at once.</p>
     *
     * <p>The ground has many ways out. A point that is deep in the ground has to go at least as far as to the nearest side. If the push is about as
     * short as that, it is taken. Otherwise the deepest part of the ground that an agent touches can be left over each side of the ground that this
     * part is behind (<code>PairTests.findWays()</code>). Each is the beginning of a push, and the shortest push that leads out is taken.</p>
     *
     * <p>If no push is found, the shortest way out of the structures around both bodies gives the direction (Parting).</p>
     *
     * @private
     */
    public final class Separation extends Parting
    {
        // How many contacts a push may lead out of, one after the other; how many pushes out of the ground are tried; the part of a push that must
        // be known to be needed, so that no other way is tried; and how many times farther other ways are looked for next.
        private static const MOST_CONTACTS:int = 4;
        private static const MOST_PUSHES:int = 80;
        private static const NEEDED:Number = 0.85;
        private static const FARTHER:Number = 3;

        // How far a push leads into a corner of an agent at most, as a fraction of the larger extent. The cosines of the angles that the contact with
        // another side of the corner has to the push.
        private static const LARGEST_CORNER:Number = 1 / 16;
        private static const LEAST_COSINE:Number = -0.1;
        private static const MOST_COSINE:Number = 0.8;

        // How much room there is beyond a push out of several contacts, as a fraction of the larger extent. Less room is a gap between parts of the
        // second body.
        private static const ROOM:Number = 100 * Tolerances.SEPARATION;

        // How much farther than needed a push leads out of each contact, as a fraction of SEPARATION.
        private static const SLACK:Number = 0.1;

        // How much of a cell of the ground counts as its extent. It is small because agents may be small, and not 0 because they may be points.
        private static const CELL_SHARE:Number = 1e-4;

        // The extent of two points at the origin. It is not 0, so all steps are longer than 0.
        private static const LEAST_EXTENT:Number = 1e-100;

        private var _pairs:RowPairs;

        // The first contact, the pushes, and the contacts with which other ways begin.
        private var _first:ContactPoint = new ContactPoint();

        // Whether the tests have found another contact since the first one.
        private var _isFirstLost:Boolean = false;
        private var _pushes:PushSearch = new PushSearch();
        private var _ways:Vector.<ContactPoint> = new Vector.<ContactPoint>();

        /** @param pairs tests which bodies touch, and when */
        public function Separation(pairs:RowPairs)
        {
            _pairs = pairs;
        }

        /**
         * Changes a contact's normal and depth so that they separate the two bodies.
         *
         * @param motion the motion of the first body relative to the second, with the time at which they touch. It ends where the first body is
         * @param out the contact of two parts that touch at that time
         */
        public function find(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _tests = _pairs.testsOf(a, b);
            if (_tests.hasExactContact(a, b))
            {
                OverlapMiddle.setAlong(a, b, out);
                return;
            }
            begin(a, b, motion);
            _distance = 0;
            // only a body that moves may have been stopped just before the touch
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
            OverlapMiddle.setAlong(_a, b, out);
            OverlapMiddle.keepWithin(_a, out);
            if (b.form != ModelShape.GROUND)
            {
                OverlapMiddle.keepWithin(b, out);
            }
        }

        private function begin(a:Body, b:Body, motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            _b = b;
            _x = a.placement.x + (motion.startX + time * motion.x);
            _y = a.placement.y + (motion.startY + time * motion.y);
            _z = a.placement.z + (motion.startZ + time * motion.z);
            _place.setTo(_x, _y, _z);
            _a.readPart(a, _place, 0);
            var share:Number = b.form == ModelShape.GROUND ? CELL_SHARE : 1;
            var half:Number = Math.max(share * b.largestHalf, a.largestHalf);
            _rounding = a.margin + b.margin;
            // two points have no extent. Then it is the gap across which they still touch
            _extent = Math.max(2 * half, Math.max(_rounding, LEAST_EXTENT));
        }

        // Handles two bodies that do not touch at the time, because of rounding. The depth is 0. The normal points against the motion, unless the
        // two touch if the first one moves a little against the given normal.
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

        // Whether the first body moves, and touches the second only after the motion's beginning.
        private static function isComing(motion:RelativeMotion):Boolean
        {
            return motion.time > 0 && (motion.x != 0 || motion.y != 0 || motion.z != 0);
        }

        // Finds the shortest way out that it can. If triangles decide and the contact is not shallow, the leaves find a direction first,
        // because their tests are fast.
        private function findLeast(motion:RelativeMotion, out:ContactPoint):void
        {
            _first.copyFrom(out);
            _isFirstLost = false;
            out.depth = Infinity;
            if (_b.form == ModelShape.GROUND)
            {
                findWayOfGround(out);
                return;
            }
            findPush(out, Infinity, 0, MOST_CONTACTS);
            if (isComing(motion) && out.depth > SHALLOW * _extent)
            {
                _first.pointAgainst(motion);
                _first.depth = 0;
                findPush(out, GAIN * out.depth, 0, MOST_CONTACTS);
            }
            if (out.depth == 0)
            {
                return;
            }
            var trees:TreePairs = _pairs.trees;
            var isExact:Boolean = trees != null && trees.exact && out.depth > SHALLOW * _extent;
            if (isExact)
            {
                trees.byLeaves = true;
            }
            tryOuter(out);
            if (isExact)
            {
                trees.byLeaves = false;
                goOutAlong(out);
                refine(out);
            }
        }

        // Tries to go straight along the shortest way out of the structures around both bodies.
        private function tryOuter(out:ContactPoint):void
        {
            _distance = 0;
            displace();
            _tests.findOuterContact(_a, _b, _left);
            if (out.depth == Infinity)
            {
                goOutAlong(_left);
                refine(out);
                return;
            }
            point(_left);
            _free = out.depth - Tolerances.SEPARATION * _extent;
            if (_free > 0 && !touchesFree())
            {
                _touching = 0;
                refine(out);
            }
        }

        // Finds a way out of the ground. The push out of one contact after the other is taken if no way is clearly shorter. Otherwise it looks
        // farther and farther for other ways, and straight up.
        private function findWayOfGround(out:ContactPoint):void
        {
            var reach:Number = Math.max(SHALLOW * _extent, Math.min(_first.depth, _extent));
            if (findPush(out, Math.max(_tests.needed / NEEDED, ROOM * _extent), 0, MOST_CONTACTS))
            {
                return;
            }
            _distance = 0;
            displace();
            _tests.findOuterContact(_a, _b, _left);
            var most:Number = _left.depth;
            while (!findPush(out, reach / NEEDED, reach, MOST_PUSHES) && reach <= most)
            {
                reach *= FARTHER;
            }
            tryOuter(out);
        }

        // Looks for the shortest push that leads out of all contacts, from the first one on. Takes it if it is not longer than the most.
        private function findPush(out:ContactPoint, most:Number, reach:Number, tries:int):Boolean
        {
            var slack:Number = SLACK * Tolerances.SEPARATION * _extent + _rounding;
            _pushes.begin();
            _left.copyFrom(_first);
            _distance = 0;
            displace();
            if (reach > 0 && _isFirstLost)
            {
                _tests.findContact(_a, _b, RelativeMotion.NONE, _left);
            }
            while (tries > 0)
            {
                _pushes.add(_left, slack);
                if (reach > 0)
                {
                    addWays(reach, slack);
                }
                if (!_pushes.next() || _pushes.length > most)
                {
                    return false;
                }
                if (isFreeAfterPush())
                {
                    takePush(out);
                    return true;
                }
                if (!findCorner())
                {
                    return false;
                }
                tries--;
            }
            return false;
        }

        private function addWays(reach:Number, slack:Number):void
        {
            _tests.reach = reach;
            var count:int = _tests.findWays(_a, _b, _ways);
            for (var i:int = 0; i < count; i++)
            {
                _pushes.add(_ways[i], slack);
            }
        }

        private function isFreeAfterPush():Boolean
        {
            _alongX = _pushes.x / _pushes.length;
            _alongY = _pushes.y / _pushes.length;
            _alongZ = _pushes.z / _pushes.length;
            _distance = _pushes.length + ROOM * _extent;
            _free = _pushes.length + Tolerances.SEPARATION / 4 * _extent;
            return (_pushes.deciding == 1 || !touch()) && !touchesFree();
        }

        // Finds the contact after a push, at another side of a corner. Agents that are deep in each other have many contacts in all directions,
        // or again in that of the push. Returns whether it may be a corner.
        private function findCorner():Boolean
        {
            var isGround:Boolean = _b.form == ModelShape.GROUND;
            if (!isGround && _pushes.length > LARGEST_CORNER * _extent)
            {
                return false;
            }
            _isFirstLost = true;
            _tests.findContact(_a, _b, RelativeMotion.NONE, _left);
            var cosine:Number = _left.normalX * _alongX + _left.normalY * _alongY + _left.normalZ * _alongZ;
            return isGround || cosine > LEAST_COSINE && cosine < MOST_COSINE;
        }

        // The two part at the end of the push, or before it.
        private function takePush(out:ContactPoint):void
        {
            out.setNormal(_alongX, _alongY, _alongZ);
            out.depth = _pushes.length;
            _distance = _pushes.length - Tolerances.SEPARATION / 4 * _extent;
            if (_distance > 0 && !touch())
            {
                _touching = 0;
                refine(out);
            }
        }
    }
}
