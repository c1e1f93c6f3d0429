package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.geometry.copyVector;
    import starlogo.geometry.Tolerances;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.pairs.PairTests;

    use namespace engine;

    /**
     * A motion of a body: how it starts, what stops it next, and when. It sweeps the shrunk body, which does not meet what the body only touches, leaves
     * or runs along. Casts, slides and straight motions begin with <code>begin()</code>. A slide then goes on from place to place: it adds planes, and
     * finds the next impact.
     *
     * <p>docs/mover.md derives the quantities.</p>
     *
     * @private
     */
    public final class ShrunkSweep
    {
        // The shrunk body meets a surface at a grazing angle if the sine of the angle between the surface and the motion is at most this.
        private static const GRAZING_SINE:Number = 0.1;

        /** The shrunk body on this motion, and the motion's tolerances. Read only. */
        public var shrunk:ShrunkBody;

        /** Where the body starts. It differs from where the motion should start if the body was pushed out of something. */
        public var start:Vector3D = new Vector3D();

        /** The pushes out of shallow overlaps: each along the normal of a contact, by its depth. */
        public var pushes:ContactList = new ContactList();

        /** The contacts of overlaps that stay (deep, or without a way out), and those that a slide has met. The motion must not cross their planes. */
        public var planes:ContactList = new ContactList();

        /** The rows that can stop the motion. Rows that a plane stands for, and one-way rows that the body passes, leave them. */
        public var obstacles:IntList = new IntList();

        private var _depenetration:Depenetration;

        // What the shrunk body meets first, and how it meets one row. They change places.
        private var _first:Impact = new Impact();
        private var _met:Impact = new Impact();

        // A motion past a row, and the place of the body at its end.
        private var _relative:RelativeMotion = new RelativeMotion();
        private var _end:Vector3D = new Vector3D();

        /** @param depenetration has the shrunk body, and frees it where a motion starts */
        public function ShrunkSweep(depenetration:Depenetration)
        {
            _depenetration = depenetration;
            shrunk = depenetration.shrunk;
        }

        /**
         * Begins a motion: it finds the tolerances, sweeps the shrunk body, and frees the body from what it overlaps.
         *
         * @param rows the rows that may be in its way
         * @param from where the motion should start
         * @return what stops the motion, valid until the next search; null if nothing does. If there are planes, it is null, because they come first
         */
        public function begin(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D):Impact
        {
            copyVector(from, start);
            pushes.clear();
            planes.clear();
            obstacles.copyFrom(rows);
            shrunk.begin(body, rows, from, motion);
            if (!hasLength(motion))
            {
                return null;
            }
            // a flat body and a one-way row need a test of where the body stands, because a sweep cannot tell
            if (!shrunk.isFlat)
            {
                var first:Impact = findFirstImpact(start, motion, true);
                if (first == null || (first.time > 0 && !body.isOneWay(first.row)))
                {
                    return first;
                }
            }
            _depenetration.depenetrate(start, obstacles, planes, pushes);
            return planes.count > 0 ? null : findStoppingImpact(start, motion);
        }

        /**
         * Finds what stops a straight motion: a plane of an overlap, or an obstacle.
         *
         * @param rows the rows that may be in its way
         * @param from where the motion should start
         * @param out receives all but its place and the wall. Its fraction is 0 for a plane
         */
        public function findStop(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, out:MotionResult):void
        {
            var impact:Impact = begin(body, rows, from, motion);
            out.row = -1;
            out.fraction = 1;
            out.startsPenetrating = planes.count > 0;
            if (out.startsPenetrating && !findCrossedPlane(motion, out))
            {
                impact = findStoppingImpact(start, motion);
            }
            if (impact != null)
            {
                out.row = impact.row;
                out.fraction = findTouchTime(impact, start, motion);
                out.contact.copyFrom(impact.contact);
                setAlong(start, motion, impact.time, out.shrunkPlace);
            }
        }

        /**
         * Finds which obstacle the shrunk body meets first, also if it is a one-way row that the body passes. It meets none if the motion has no length.
         * Of those that are met at the same time, the first one in their order counts. An obstacle whose contact does not point against the motion
         * counts a clearance later, unless it is met at once. So if a corner of the shrunk body enters a floor exactly between two tiles, along the side
         * of one of them, the top of the other stops it.
         *
         * @param from where the body is
         * @param motion what is left of the motion
         * @param isStart whether the motion starts there. Then the body may be inside of obstacles, and meets these at once
         * @return valid until the next search; null if it meets none
         */
        public function findFirstImpact(from:Vector3D, motion:Vector3D, isStart:Boolean = false):Impact
        {
            var end:int = hasLength(motion) ? obstacles.count : 0;
            var first:Number = RelativeMotion.NEVER;
            for (var i:int = 0; i < end && first > 0; i++)
            {
                if (findRowImpact(obstacles.values[i], from, motion, isStart, _met))
                {
                    var time:Number = _met.isNormalFallback && _met.time > 0 ? _met.time + shrunk.clearance / motion.length : _met.time;
                    if (time < first)
                    {
                        var met:Impact = _met;
                        _met = _first;
                        _first = met;
                        first = time;
                    }
                }
            }
            return first < RelativeMotion.NEVER ? _first : null;
        }

        /**
         * Finds which obstacle stops the shrunk body first. One-way rows that the body passes leave the obstacles.
         *
         * @return valid until the next search; null if none does
         */
        public function findStoppingImpact(from:Vector3D, motion:Vector3D):Impact
        {
            var first:Impact = findFirstImpact(from, motion);
            while (first != null && shrunk.body.passesOneWay(first.row, first.contact))
            {
                obstacles.remove(first.row);
                first = findFirstImpact(from, motion);
            }
            return first;
        }

        /** Whether a row near the way of a body would stop its shrunk body on a straight motion. What that overlaps at the beginning stops it too. */
        public function meets(body:MovingBody, row:int, from:Vector3D, motion:Vector3D):Boolean
        {
            shrunk.begin(body, body.rows, from, motion);
            return hasLength(motion) && findRowImpact(row, from, motion, false, _met);
        }

        /**
         * Finds when the full body touches the row of an impact. The body touches the contact's plane earlier than the shrunk body, because its surface
         * is in front of the shrunk body's at the contact. Only an inner face of a concave body is behind the shrunk body's, and touches later.
         * Mostly the touch of the plane is the touch. But at a grazing angle, the body touches a curved surface much nearer to where the shrunk body
         * does. So there, and at an inner face, the body is swept too. Its time counts if it is between the two. If the body touches the row
         * elsewhere, before or after, the nearer one of the two counts.
         */
        public function findTouchTime(impact:Impact, from:Vector3D, motion:Vector3D):Number
        {
            var contact:ContactPoint = impact.contact;
            var fullBody:Body = shrunk.body.fullBody;
            var shrink:Number = shrunk.shrink;
            var recess:Number = shrink / (1 - shrink) * (contact.normalX * (from.x + fullBody.offsetX + impact.time * motion.x - contact.x)
                    + contact.normalY * (from.y + fullBody.offsetY + impact.time * motion.y - contact.y)
                    + contact.normalZ * (from.z + fullBody.offsetZ + impact.time * motion.z - contact.z));
            var along:Number = contact.along(motion);
            var ofPlane:Number = Math.max(0, Math.min(1, impact.time + recess / along));
            var isGrazing:Boolean = !(along < -GRAZING_SINE * motion.length);
            if (!isGrazing && !(recess < 0))
            {
                return ofPlane;
            }
            setAlong(from, motion, 1, _end);
            _relative.endAfter(motion.x, motion.y, motion.z);
            shrunk.body.testsWith(impact.row).findImpactOfSurfaces(shrunk.body.moveTo(_end), shrunk.body.bodyOf(impact.row), _relative, null);
            var earliest:Number = Math.min(ofPlane, impact.time);
            var latest:Number = Math.max(ofPlane, impact.time);
            return Math.max(earliest, Math.min(latest, _relative.time));
        }

        /** Sets the place at a time of a motion. */
        public static function setAlong(from:Vector3D, motion:Vector3D, time:Number, out:Vector3D):void
        {
            // not setTo, because the ES module checks its arguments
            out.x = from.x + time * motion.x;
            out.y = from.y + time * motion.y;
            out.z = from.z + time * motion.z;
        }

        private static function hasLength(motion:Vector3D):Boolean
        {
            // not lengthSquared, because V8 makes an object for the Number of a getter
            return motion.x * motion.x + motion.y * motion.y + motion.z * motion.z > Tolerances.VANISHING;
        }

        // Finds the plane that the motion crosses at the steepest angle. It stops the motion at once, without a triangle, because the plane stands for all
        // triangles of the row. Returns whether the motion crosses one.
        private function findCrossedPlane(motion:Vector3D, out:MotionResult):Boolean
        {
            var least:Number = -RemainingMotion.PARALLEL_SINE * motion.length;
            for (var i:int = 0; i < planes.count; i++)
            {
                var along:Number = planes.contacts[i].along(motion);
                if (along < least)
                {
                    least = along;
                    out.row = planes.rows[i];
                    out.contact.copyFrom(planes.contacts[i]);
                    out.contact.triangle = -1;
                    out.fraction = 0;
                }
            }
            return out.hasContact;
        }

        // Finds when and how a row stops the shrunk body. If the first contact does not point against the motion, the shrunk body leaves there what
        // it touches. At the same time it may enter another face, as the top of a tile at its edge. So it is swept again from a clearance farther on.
        // A flat shrunk body may be past a sheet there, so it is not swept again. Returns whether the row stops it.
        private function findRowImpact(row:int, from:Vector3D, motion:Vector3D, isStart:Boolean, out:Impact):Boolean
        {
            var contact:ContactPoint = out.contact;
            setAlong(from, motion, 1, _end);
            _relative.endAfter(motion.x, motion.y, motion.z);
            sweepPast(row, _end, _relative, isStart, contact);
            if (_relative.time == RelativeMotion.NEVER)
            {
                return false;
            }
            var against:Number = -RemainingMotion.PARALLEL_SINE * motion.length;
            out.time = _relative.time;
            if (out.time > 0 && !(contact.along(motion) < against) && !shrunk.isFlat)
            {
                var beyond:Number = Math.min(1, out.time + shrunk.clearance / motion.length);
                var rest:Number = 1 - beyond;
                _relative.endAfter(rest * motion.x, rest * motion.y, rest * motion.z);
                sweepPast(row, _end, _relative, false, contact);
                if (_relative.time == RelativeMotion.NEVER)
                {
                    return false;
                }
                out.time = beyond + rest * _relative.time;
            }
            out.row = row;
            out.isNormalFallback = !(contact.along(motion) < against);
            if (out.isNormalFallback)
            {
                contact.setNormal(-motion.x, -motion.y, -motion.z);
                contact.normalise();
            }
            return true;
        }

        // Finds when and how the shrunk body first meets a row on a motion that ends at a place, and receives the time. A sheet may be wholly under the ground
        // at any time, and then it touches no surface.
        private function sweepPast(row:int, end:Vector3D, motion:RelativeMotion, isStart:Boolean, out:ContactPoint):void
        {
            var moved:Body = shrunk.moveTo(end);
            var other:Body = shrunk.body.bodyOf(row);
            if (!shrunk.isNear(moved, other, motion))
            {
                motion.time = RelativeMotion.NEVER;
                return;
            }
            var tests:PairTests = shrunk.body.narrowPhase.pairTestsFor(moved, other);
            if (isStart || other.kind == ModelShape.GROUND)
            {
                tests.findImpactOfSolids(moved, other, motion, out);
            }
            else
            {
                tests.findImpactOfSurfaces(moved, other, motion, out);
            }
        }
    }
}
