package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * Finds a normal and a depth for a contact that separate its two bodies. If the first one moves along the normal by the depth, no part of it
     * touches the second one any more.
     *
     * <p>It begins with a push along the given normal. If the two still touch after a push, their contact there is added, and the next push is
     * the shortest one out of all contacts so far (PushSearch). So a box in a corner of floor and wall goes out of both at once.</p>
     *
     * <p>An agent in the ground may have many ways out. Its contact may have a lower bound of their lengths (<code>leastDepth</code>). If the
     * first push is hardly longer, it is taken. Otherwise each side of the ground that the deepest touched part is behind begins a push of
     * its own (<code>PairTests.findExits()</code>). The shortest push that frees the agent is taken. Contacts may contradict each other, as
     * opposite walls do, and the ground ends at edges, where a push out of the whole plane is longer than needed. So a push that
     * does not free the agent is changed: it goes as far along the ground, and from there as high as the agent has to be
     * lifted. The shortest of these ways is taken if no push is shorter. One sweep down finds each lift, because all places above a
     * free one are free.</p>
     *
     * <p>The shortest way out of the structures around both bodies is tried too; if no push is found, it gives the direction
     * (DirectionSearch).</p>
     *
     * @private
     */
    internal final class PenetrationSearch
    {
        // The most contacts that a push leads out of, and the most pushes out of the ground that are tried.
        private static const MOST_CONTACTS:int = 4;
        private static const MOST_PUSHES:int = 80;

        // No other way is tried if the least length of a way out is at least this fraction of the push.
        private static const NEEDED:Number = 0.85;

        // The factor by which the search distance for other ways grows.
        private static const FARTHER:Number = 3;

        // How far a push leads into a corner of an agent at most, as a fraction of the larger extent. After a push, a contact counts as another
        // side of the same corner if the cosine between its normal and the push is between these two. If the push is also this short for
        // the smaller extent, the corner may be acute, and the contact may be of the same side: a face beside an edge that was met first.
        private static const LARGEST_CORNER:Number = 1 / 16;
        private static const LEAST_COSINE:Number = -0.1;
        private static const LEAST_ACUTE_COSINE:Number = -0.99;
        private static const MOST_COSINE:Number = 0.8;

        // A push out of several contacts counts only if the body is free this much farther along it too, as a fraction of the larger extent.
        // Otherwise it ends in a gap between parts of the second body.
        private static const ROOM:Number = 100 * Tolerances.SEPARATION;

        // How much farther than its depth a push leads out of each contact, as a fraction of SEPARATION. This is more than the gap across which
        // surfaces touch.
        private static const SLACK:Number = 0.001;

        private var _pairTests:PairTests;
        private var _pair:DisplacedPair;
        private var _directions:DirectionSearch;

        // The first contact.
        private var _first:ContactPoint = new ContactPoint();

        // Whether the tests have found another contact since the first one.
        private var _isFirstLost:Boolean = false;

        // The contact that was found last, and the displacement that is tried.
        private var _contact:ContactPoint = new ContactPoint();
        private var _tried:Displacement = new Displacement();

        // The pushes, and the contacts with which other ways begin.
        private var _pushes:PushSearch = new PushSearch();
        private var _exits:Vector.<ContactPoint> = new Vector.<ContactPoint>();

        // The direction and the length of the shortest way out of the ground that ends with a lift; the sweep down and
        // the contact at its end; and where the first body is for them.
        private var _lift:Vector3D = new Vector3D();
        private var _liftLength:Number = 0;
        private var _below:ContactPoint = new ContactPoint();
        private var _down:RelativeMotion = new RelativeMotion();
        private var _offset:Vector3D = new Vector3D();

        /** @param pairTests decides whether bodies touch, and when. It is for pairs with a tree, or with the ground */
        public function PenetrationSearch(pairTests:PairTests)
        {
            _pairTests = pairTests;
            _pair = new DisplacedPair(pairTests);
            _directions = new DirectionSearch(_pair);
        }

        /**
         * Changes a contact's normal and depth so that they separate the two bodies.
         *
         * @param motion the motion of the first body relative to the second, with the time at which they touch. It ends where the first body is
         * @param out the contact of two parts that touch at that time
         */
        public function find(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _pair.begin(a, b, motion);
            // only a body that moves may have been stopped just before the touch
            if (!isComing(motion) || _pair.areTouching())
            {
                findLeast(motion, out);
            }
            else
            {
                findGrazing(motion, out);
            }
            _pair.putBack();
            OverlapMiddle.setAlong(_pair.first, b, out);
            OverlapMiddle.keepWithin(_pair.first, out);
            if (!_pair.isSecondGround)
            {
                OverlapMiddle.keepWithin(b, out);
            }
        }

        // Handles two bodies that do not touch at the time, because of rounding. The depth is 0. The normal points against the motion, unless the
        // two touch if the first one moves a little against the given normal.
        private function findGrazing(motion:RelativeMotion, out:ContactPoint):void
        {
            out.depth = 0;
            aim(out);
            _tried.distance = -Math.max(Tolerances.SEPARATION / 4 * _pair.extent, _pair.rounding);
            if (!_pair.touchesAt(_tried))
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
            if (_pair.isSecondGround)
            {
                findGroundExit(out);
                return;
            }
            findPush(out, Infinity);
            if (isComing(motion) && out.depth > DirectionSearch.SHALLOW * _pair.extent)
            {
                _first.pointAgainst(motion);
                _first.depth = 0;
                findPush(out, DirectionSearch.GAIN * out.depth);
            }
            if (out.depth == 0)
            {
                return;
            }
            var trees:TreePairTests = TreePairTests(_pairTests);
            _pair.first.isOfLeaves = trees.limits.exact && out.depth > DirectionSearch.SHALLOW * _pair.extent;
            tryOuter(out);
            if (_pair.first.isOfLeaves)
            {
                _pair.first.isOfLeaves = false;
                _directions.findAlong(out, out);
            }
        }

        // Tries to go straight along the shortest way out of the structures around both bodies.
        private function tryOuter(out:ContactPoint):void
        {
            _pair.putBack();
            _pair.findOuterContact(_contact);
            if (out.depth == Infinity)
            {
                _directions.findAlong(_contact, out);
                return;
            }
            aim(_contact);
            _tried.distance = out.depth - Tolerances.SEPARATION * _pair.extent;
            if (_tried.distance > 0 && !_pair.touchesAt(_tried))
            {
                _directions.shorten(_tried, out);
            }
        }

        // Finds a way out of the ground. The push out of one contact after the other is taken if no way is clearly shorter. Otherwise it looks
        // farther and farther for other ways, and for ways that end with a lift. The first of these goes straight up, above all ground around.
        private function findGroundExit(out:ContactPoint):void
        {
            var maxDistance:Number = Math.max(DirectionSearch.SHALLOW * _pair.extent, Math.min(_first.depth, _pair.extent));
            if (findPush(out, Math.max(_first.leastDepth / NEEDED, ROOM * _pair.extent)))
            {
                return;
            }
            _pair.putBack();
            _pair.findOuterContact(_below);
            _liftLength = _below.depth + Tolerances.SEPARATION * _pair.extent;
            _lift.setTo(0, 0, 1);
            while (!findPushOrLift(out, maxDistance) && maxDistance / NEEDED <= _liftLength)
            {
                maxDistance *= FARTHER;
            }
            if (_liftLength < out.depth - Tolerances.SEPARATION * _pair.extent)
            {
                _below.setNormal(_lift.x, _lift.y, _lift.z);
                _below.depth = _liftLength;
                _directions.findAlong(_below, out);
            }
        }

        // Finds how high the first body has to be lifted after it has gone along the ground as far as the push. Keeps this way out if it is the
        // shortest one so far. The lift is that of a place ROOM farther, so that the body is free a little farther along the way too,
        // even between walls that are as far apart as it is wide. A push that is too long leads past an edge of the ground on the way: it goes
        // half as far as the shortest way.
        private function tryLift():void
        {
            var x:Number = _pushes.push.x;
            var y:Number = _pushes.push.y;
            var length:Number = Math.sqrt(x * x + y * y);
            var farther:Number = length > 0 ? 1 + ROOM * _pair.extent / length : 1;
            if (length >= _liftLength)
            {
                farther = 1;
                x *= _liftLength / (2 * length);
                y *= _liftLength / (2 * length);
            }
            x *= farther;
            y *= farther;
            var squared:Number = _liftLength * _liftLength - (x * x + y * y);
            if (!(squared > 0))
            {
                return;
            }
            var high:Number = Math.sqrt(squared);
            _offset.setTo(x, y, high);
            _pair.displaceBy(_offset);
            if (_pair.areTouching())
            {
                return;
            }
            _offset.z = 0;
            _pair.displaceBy(_offset);
            _down.endAfter(0, 0, -high);
            _pairTests.findImpact(_pair.first, _pair.second, _down, _below);
            var z:Number = high * (1 - Math.min(_down.time, 1));
            // halfway between the place of the push and the one farther
            x *= (1 + farther) / (2 * farther);
            y *= (1 + farther) / (2 * farther);
            length = Math.sqrt(x * x + y * y + z * z);
            if (length == 0)
            {
                return;
            }
            _tried.x = x / length;
            _tried.y = y / length;
            _tried.z = z / length;
            _tried.distance = length + Tolerances.SEPARATION * _pair.extent;
            if (!_pair.touchesAt(_tried))
            {
                _lift.setTo(_tried.x, _tried.y, _tried.z);
                _liftLength = length;
            }
        }

        // Looks for the shortest push that leads out of all contacts, from the first one on. Takes it if it is not longer than
        // <code>most</code>. Returns whether it has taken one.
        private function findPush(out:ContactPoint, most:Number):Boolean
        {
            var slack:Number = beginPushes();
            for (var tries:int = MOST_CONTACTS; tries > 0; tries--)
            {
                _pushes.add(_contact, slack);
                if (!_pushes.next() || _pushes.length > most)
                {
                    return false;
                }
                if (tryPush())
                {
                    takePush(out);
                    return true;
                }
                if (!findCorner())
                {
                    return false;
                }
            }
            return false;
        }

        // Looks for the shortest push out of the ground, also out of its sides that are at most a distance away. Tries a lift after each other
        // push. Takes a push that frees the body if it is neither much longer than the distance nor longer than the shortest lift. Returns
        // whether it has taken one.
        private function findPushOrLift(out:ContactPoint, maxDistance:Number):Boolean
        {
            var slack:Number = beginPushes();
            if (_isFirstLost)
            {
                _pair.findContact(_contact);
            }
            for (var tries:int = MOST_PUSHES; tries > 0; tries--)
            {
                _pushes.add(_contact, slack);
                addExits(maxDistance, slack);
                tryLift();
                if (!_pushes.next())
                {
                    return false;
                }
                if (_pushes.length > Math.min(maxDistance / NEEDED, _liftLength))
                {
                    tryLift();
                    return false;
                }
                if (tryPush())
                {
                    takePush(out);
                    return true;
                }
                findCorner();
            }
            return false;
        }

        // Begins with the first contact, where it is. Returns how much farther than its depth a push leads out of each contact.
        private function beginPushes():Number
        {
            _pushes.begin();
            _contact.copyFrom(_first);
            _pair.putBack();
            return SLACK * Tolerances.SEPARATION * _pair.extent + _pair.rounding;
        }

        private function addExits(maxDistance:Number, slack:Number):void
        {
            var count:int = _pairTests.findExits(_pair.first, _pair.second, maxDistance, _exits);
            for (var i:int = 0; i < count; i++)
            {
                _pushes.add(_exits[i], slack);
            }
        }

        // Tries the current push. Returns whether the first body is free after it.
        private function tryPush():Boolean
        {
            _tried.x = _pushes.push.x / _pushes.length;
            _tried.y = _pushes.push.y / _pushes.length;
            _tried.z = _pushes.push.z / _pushes.length;
            var farther:Number = _pushes.length + Tolerances.SEPARATION / 4 * _pair.extent;
            if (_pushes.deciding > 1)
            {
                // beyond its end, a push out of several contacts may lead into one of them again
                _tried.distance = _pushes.length;
                if (_pair.touchesAt(_tried))
                {
                    return false;
                }
            }
            _tried.distance = farther;
            if (_pair.touchesAt(_tried))
            {
                return false;
            }
            if (_pushes.deciding == 1)
            {
                return true;
            }
            _tried.distance = _pushes.length + ROOM * _pair.extent;
            return !_pair.touchesAt(_tried);
        }

        // Finds the contact after a push. Returns whether it may be a side of a corner. It may not if it points against the push, or along it
        // after a long one, as for agents deep in each other.
        private function findCorner():Boolean
        {
            var isGround:Boolean = _pair.isSecondGround;
            if (!isGround && _pushes.length > LARGEST_CORNER * _pair.extent)
            {
                return false;
            }
            _isFirstLost = true;
            _pair.findContact(_contact);
            var cosine:Number = _contact.normalX * _tried.x + _contact.normalY * _tried.y + _contact.normalZ * _tried.z;
            // the body is a little farther than the push
            _contact.depth += (_tried.distance - _pushes.length) * cosine;
            if (isGround)
            {
                return true;
            }
            var isShort:Boolean = _pushes.length <= 2 * LARGEST_CORNER * Math.min(_pair.first.largestHalf, _pair.second.largestHalf);
            return isShort ? cosine > LEAST_ACUTE_COSINE : cosine > LEAST_COSINE && cosine < MOST_COSINE;
        }

        // Takes the push. If the two are free before its end, the depth is refined. The first push out of the ground needs no test if its contact is sure of its depth.
        private function takePush(out:ContactPoint):void
        {
            out.setNormal(_tried.x, _tried.y, _tried.z);
            out.depth = _pushes.length;
            if (!_isFirstLost && _pair.isSecondGround && _first.isDepthSure)
            {
                return;
            }
            _tried.distance = _pushes.length - Tolerances.SEPARATION / 4 * _pair.extent;
            if (_tried.distance > 0 && !_pair.touchesAt(_tried))
            {
                _directions.shorten(_tried, out);
            }
        }

        private function aim(contact:ContactPoint):void
        {
            _tried.x = contact.normalX;
            _tried.y = contact.normalY;
            _tried.z = contact.normalZ;
        }
    }
}
