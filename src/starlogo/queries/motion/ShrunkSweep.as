package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.pairs.PairTests;

    use namespace engine;

    /**
     * Finds how a motion starts, what stops a body on a straight motion, and when. It sweeps the shrunk body, which does not meet what the body only
     * touches, leaves or runs along. Casts, slides and straight motions start with <code>startMotion()</code>.
     *
     * <p>docs/mover.md derives the quantities.</p>
     *
     * @private
     */
    public final class ShrunkSweep
    {
        // The shrunk body meets a surface at a grazing angle if the sine of the angle between the surface and the motion is at most this.
        private static const GRAZING_SINE:Number = 0.1;

        private var _depenetration:Depenetration = new Depenetration();

        // How the shrunk body meets one row.
        private var _met:Impact = new Impact();

        // The motion of the shrunk body past a row, and the place of the body at its end.
        private var _relative:RelativeMotion = new RelativeMotion();
        private var _end:Vector3D = new Vector3D();

        /**
         * Starts a motion: it finds the tolerances, sweeps the shrunk body, and frees the body from what it overlaps. If the body overlaps nothing,
         * the sweep has found what stops the motion first.
         *
         * @param rows the rows that may be in its way
         * @param from where the motion begins
         * @param out receives the answer
         */
        public function startMotion(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, out:MotionState):void
        {
            out.start.copyFrom(from);
            out.pushes.clear();
            out.planes.clear();
            out.obstacles.copyFrom(rows);
            out.impact.row = -1;
            out.shrunk.begin(body, rows, from, motion);
            out.isImpactKnown = !hasLength(motion) || tryStartFree(out.shrunk, out.obstacles, from, motion, out.impact);
            if (!out.isImpactKnown)
            {
                _depenetration.depenetrate(out);
            }
        }

        /**
         * Finds what stops a straight motion: a plane of an overlap, or an obstacle.
         *
         * @param rows the rows that may be in its way
         * @param from where the motion begins
         * @param state receives how it starts, and what stops it as its impact
         * @return when the body touches that: from 0 to 1; 0 for a plane, 1 if nothing stops it
         */
        public function findStop(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, state:MotionState):Number
        {
            startMotion(body, rows, from, motion, state);
            if (!state.isImpactKnown)
            {
                if (findCrossedPlane(state.planes, motion, state.impact))
                {
                    return 0;
                }
                findFirstSolidImpact(state.shrunk, state.obstacles, state.start, motion, state.impact);
            }
            return state.impact.isMet ? findTouchTime(state.shrunk, state.start, motion, state.impact) : 1;
        }

        /**
         * Finds which row a shrunk body meets first, also if it is a one-way row that the body passes: none, if the motion has no length. Of rows
         * with the same <code>orderTime</code>, the first one in their order counts.
         *
         * @param from where the motion begins
         * @param out receives the answer
         * @return whether anything is met
         */
        public function findFirstImpact(shrunk:ShrunkBody, rows:IntList, from:Vector3D, motion:Vector3D, out:Impact):Boolean
        {
            out.row = -1;
            out.time = out.orderTime = RelativeMotion.NEVER;
            var end:int = hasLength(motion) ? rows.count : 0;
            for (var i:int = 0; i < end && out.orderTime > 0; i++)
            {
                if (findRowImpact(shrunk, rows.values[i], from, motion, _met) && _met.orderTime < out.orderTime)
                {
                    out.copyFrom(_met);
                }
            }
            return out.isMet;
        }

        /**
         * Finds which obstacle a shrunk body meets first.
         *
         * @param obstacles the rows that can stop it. One-way rows that the body passes leave the list
         * @param from where the motion begins
         * @param out receives the answer
         */
        public function findFirstSolidImpact(shrunk:ShrunkBody, obstacles:IntList, from:Vector3D, motion:Vector3D, out:Impact):void
        {
            while (findFirstImpact(shrunk, obstacles, from, motion, out) && shrunk.mover.passesOneWay(out.row, out.contact))
            {
                obstacles.remove(out.row);
            }
        }

        /** Whether a row would stop a shrunk body on a straight motion. What it overlaps at the beginning stops it too. */
        public function meets(shrunk:ShrunkBody, row:int, from:Vector3D, motion:Vector3D):Boolean
        {
            return hasLength(motion) && findRowImpact(shrunk, row, from, motion, _met);
        }

        /**
         * Finds when the whole body touches the row that the shrunk body has met. The body touches the contact's plane earlier, because its surface
         * is in front of the shrunk body's at the contact. Only an inner face of a concave body is behind the shrunk body's, and touches later.
         * Mostly the touch of the plane is the touch. But at a grazing angle, the body touches a curved surface much nearer to where the shrunk body
         * does. So there, and at an inner face, the body is swept too. Its time counts if it is between the two. If the body touches the row
         * elsewhere, before or after, the nearer one of the two counts.
         *
         * @param impact how the shrunk body meets it
         */
        public function findTouchTime(shrunk:ShrunkBody, from:Vector3D, motion:Vector3D, impact:Impact):Number
        {
            var contact:ContactPoint = impact.contact;
            var whole:Body = shrunk.mover.whole;
            var shrink:Number = shrunk.shrink;
            var recess:Number = shrink / (1 - shrink) * (contact.normalX * (from.x + whole.offsetX + impact.time * motion.x - contact.x)
                    + contact.normalY * (from.y + whole.offsetY + impact.time * motion.y - contact.y)
                    + contact.normalZ * (from.z + whole.offsetZ + impact.time * motion.z - contact.z));
            var along:Number = contact.along(motion);
            var ofPlane:Number = Math.max(0, Math.min(1, impact.time + recess / along));
            var isGrazing:Boolean = !(along < -GRAZING_SINE * motion.length);
            if (!isGrazing && !(recess < 0))
            {
                return ofPlane;
            }
            setAlong(from, motion, 1, _end);
            shrunk.mover.moveTo(_end);
            var other:Body = shrunk.mover.bodyOf(impact.row);
            _relative.endAfter(motion.x, motion.y, motion.z);
            shrunk.mover.narrowPhase.pairTestsFor(whole, other).findImpactOfSurfaces(whole, other, _relative, null);
            var earliest:Number = Math.min(ofPlane, impact.time);
            var latest:Number = Math.max(ofPlane, impact.time);
            return Math.max(earliest, Math.min(latest, _relative.time));
        }

        /** Sets the place at a time of a motion. */
        public static function setAlong(from:Vector3D, motion:Vector3D, time:Number, out:Vector3D):void
        {
            out.setTo(from.x + time * motion.x, from.y + time * motion.y, from.z + time * motion.z);
        }

        private static function hasLength(motion:Vector3D):Boolean
        {
            return motion.lengthSquared > Tolerances.VANISHING;
        }

        // Tries to find what stops the shrunk body first by a sweep alone. Returns whether it has succeeded: then the shrunk body overlaps nothing where the
        // motion begins. Otherwise the impact means nothing: the body is flat, or touches something there, or a one-way obstacle comes first.
        private function tryStartFree(shrunk:ShrunkBody, obstacles:IntList, from:Vector3D, motion:Vector3D, out:Impact):Boolean
        {
            if (shrunk.isFlat || (findFirstImpact(shrunk, obstacles, from, motion, out) && (out.time == 0 || shrunk.mover.isOneWay(out.row))))
            {
                return false;
            }
            // it touches no surface where the motion begins
            setAlong(from, motion, 1, _end);
            _relative.endAfter(motion.x, motion.y, motion.z);
            var isInside:Boolean = false;
            for (var i:int = 0; i < obstacles.count && !isInside; i++)
            {
                isInside = beginsInside(shrunk, obstacles.values[i], _end, _relative);
            }
            return !isInside;
        }

        // Whether the shrunk body or a row is inside of the other where a motion begins.
        private static function beginsInside(shrunk:ShrunkBody, row:int, end:Vector3D, motion:RelativeMotion):Boolean
        {
            var moved:Body = shrunk.moveTo(end);
            var other:Body = shrunk.mover.bodyOf(row);
            return shrunk.isNear(moved, other, motion) && shrunk.mover.narrowPhase.pairTestsFor(moved, other).beginsInside(moved, other, motion);
        }

        // Finds the plane that the motion crosses at the steepest angle. Its contact is without a triangle, because the plane stands for all triangles of the
        // row. Returns whether the motion crosses one.
        private static function findCrossedPlane(planes:ContactList, motion:Vector3D, out:Impact):Boolean
        {
            var least:Number = -RemainingMotion.PARALLEL_SINE * motion.length;
            out.row = -1;
            for (var i:int = 0; i < planes.count; i++)
            {
                var along:Number = planes.contacts[i].along(motion);
                if (along < least)
                {
                    least = along;
                    out.row = planes.rows[i];
                    out.contact.copyFrom(planes.contacts[i]);
                }
            }
            out.time = out.orderTime = 0;
            out.isNormalFallback = false;
            out.contact.triangle = -1;
            return out.isMet;
        }

        // Finds when and how a row stops the shrunk body. If the first contact does not point against the motion, the shrunk body leaves there what
        // it touches. At the same time it may enter another face, as the top of a tile at its edge. So it is swept again from a clearance farther on.
        // A flat shrunk body may be past a sheet there, so it is not swept again. Returns whether the row stops it.
        private function findRowImpact(shrunk:ShrunkBody, row:int, from:Vector3D, motion:Vector3D, out:Impact):Boolean
        {
            var contact:ContactPoint = out.contact;
            setAlong(from, motion, 1, _end);
            _relative.endAfter(motion.x, motion.y, motion.z);
            if (!sweepShrunk(shrunk, row, _end, _relative, contact))
            {
                return false;
            }
            var length:Number = motion.length;
            var clearanceTime:Number = shrunk.clearance / length;
            var against:Number = -RemainingMotion.PARALLEL_SINE * length;
            out.time = _relative.time;
            if (out.time > 0 && !(contact.along(motion) < against) && !shrunk.isFlat)
            {
                var beyond:Number = Math.min(1, out.time + clearanceTime);
                var rest:Number = 1 - beyond;
                _relative.endAfter(rest * motion.x, rest * motion.y, rest * motion.z);
                if (!sweepShrunk(shrunk, row, _end, _relative, contact))
                {
                    return false;
                }
                out.time = beyond + rest * _relative.time;
            }
            out.row = row;
            out.orderTime = out.time;
            out.isNormalFallback = !(contact.along(motion) < against);
            if (out.isNormalFallback)
            {
                contact.setNormal(-motion.x, -motion.y, -motion.z);
                contact.normalise();
                out.orderTime = out.time > 0 ? out.time + clearanceTime : 0;
            }
            return true;
        }

        // Finds when and how the shrunk body first meets a row on a motion, which receives the time. Returns whether it meets the row.
        private static function sweepShrunk(shrunk:ShrunkBody, row:int, end:Vector3D, motion:RelativeMotion, out:ContactPoint):Boolean
        {
            var moved:Body = shrunk.moveTo(end);
            var other:Body = shrunk.mover.bodyOf(row);
            motion.time = RelativeMotion.NEVER;
            if (shrunk.isNear(moved, other, motion))
            {
                var tests:PairTests = shrunk.mover.narrowPhase.pairTestsFor(moved, other);
                tests.findImpactOfSurfaces(moved, other, motion, out);
                // a sheet may be wholly under the ground at the beginning, and then it touches no surface
                if (motion.time == RelativeMotion.NEVER && other.form == ModelShape.GROUND && tests.beginsInside(moved, other, motion))
                {
                    motion.time = 0;
                    out.setNormal(0, 0, 0);
                }
            }
            return motion.time != RelativeMotion.NEVER;
        }
    }
}
