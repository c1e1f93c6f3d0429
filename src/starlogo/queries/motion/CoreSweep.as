package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * Sweeps the core of a body. What the core meets stops the body. The core does not meet what the body only touches, leaves or runs along.
     *
     * <p>docs/mover.md derives the quantities.</p>
     *
     * @private
     */
    public final class CoreSweep
    {
        // A row is large if its largest half-extent is at least this many times the largest of the body that moves.
        private static const LARGE:Number = 8;

        // A core meets something soon after the body if it moves at most this many slops on. Then the angle to the surface is more than 4 degrees.
        private static const SOON:Number = 16;

        private var _seen:SeenAgents;

        // The motion, the body's place at its end, the motion's length, and the contact that was found last.
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _end:Vector3D = new Vector3D();
        private var _length:Number = 0;
        private var _contact:ContactPoint = new ContactPoint();

        /** @param seen has the rows */
        public function CoreSweep(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Finds what the core meets first.
         *
         * @param body the body that moves. What it meets are its obstacles. Of rows that are met at the same time, the first one counts
         * @param from where the motion begins
         * @param out receives the answer; the time of the touch only if it is found on the way, and else NaN
         * @return whether anything is met
         */
        public function findFirst(body:MovingBody, from:Vector3D, motion:Vector3D, out:Impact):Boolean
        {
            aim(from, motion);
            out.row = out.clearRow = -1;
            out.time = RelativeMotion.NEVER;
            for (var i:int = 0; i < body.obstacles.count; i++)
            {
                keepEarlier(body, body.obstacles.numbers[i], from, out);
            }
            if (out.row < 0)
            {
                return false;
            }
            out.along = out.contact.along(motion);
            out.isNormalFallback = !(out.along < -SlidePlanes.PARALLEL_SINE * _length);
            if (out.isNormalFallback)
            {
                out.contact.setNormal(-motion.x, -motion.y, -motion.z);
                out.contact.normalise();
                out.along = -_length;
            }
            return true;
        }

        /** Finds what stops the core first, as <code>findFirst()</code> does. One-way rows that the body passes are no obstacles from then on. */
        public function findObstacle(body:MovingBody, from:Vector3D, motion:Vector3D, out:Impact):Boolean
        {
            while (findFirst(body, from, motion, out))
            {
                if (!body.passes(out.row, out.contact))
                {
                    return true;
                }
                body.obstacles.remove(out.row);
            }
            return false;
        }

        /** Whether the core meets a row. */
        public function meets(body:MovingBody, row:int, from:Vector3D, motion:Vector3D):Boolean
        {
            aim(from, motion);
            sweepCore(body, _seen.table.bodyOf(row), from);
            return _motion.time != RelativeMotion.NEVER;
        }

        /**
         * Finds when the whole body first touches the row that its core meets. The two may touch from the beginning, for example if one agent is
         * the floor under the body and also the wall in its way. Then the result is the time of the core, made earlier by how far
         * the core is behind the body's surface at the contact.
         *
         * @param impact what <code>findFirst()</code> has found on this motion. It receives the time
         */
        public function findTouchTime(body:MovingBody, from:Vector3D, motion:Vector3D, impact:Impact):void
        {
            aim(from, motion);
            var whole:Body = body.wholeAt(_end);
            var other:Body = _seen.table.bodyOf(impact.row);
            var contact:ContactPoint = impact.contact;
            var left:Number = 1 - impact.time;
            var recess:Number = body.core.shrink * (contact.normalX * (whole.x - left * motion.x - contact.x)
                    + contact.normalY * (whole.y - left * motion.y - contact.y)
                    + contact.normalZ * (whole.z - left * motion.z - contact.z));
            var early:Number = Math.max(0, Math.min(1, impact.time + recess / impact.along));
            if (isNaN(impact.touchTime))
            {
                _seen.narrowPhase.testsOf(whole, other).findImpact(whole, other, _motion, null);
                impact.touchTime = _motion.time;
            }
            if (!(Math.abs(impact.touchTime - early) <= Math.abs(impact.time - early)))
            {
                impact.touchTime = early;
            }
        }

        private function aim(from:Vector3D, motion:Vector3D):void
        {
            _end.copyFrom(from);
            _end.incrementBy(motion);
            _motion.endAfter(motion.x, motion.y, motion.z);
            _length = Math.sqrt(motion.x * motion.x + motion.y * motion.y + motion.z * motion.z);
        }

        // Sweeps against a row. If the core meets it earlier than what was found before, it is the answer. The whole body is swept first against
        // a tree that is much larger, because then mostly the core needs no sweep, and the end of the motion no test of its own. Such a tree
        // can be a whole building, in which everything happens.
        private function keepEarlier(body:MovingBody, row:int, from:Vector3D, out:Impact):void
        {
            var other:Body = _seen.table.bodyOf(row);
            var touchTime:Number = NaN;
            if (other.form == ModelShape.TREE && 2 * other.largestHalf >= LARGE * body.extent)
            {
                sweep(body.wholeAt(_end), other, body.core.slop, null);
                touchTime = _motion.time;
                if (touchTime == RelativeMotion.NEVER)
                {
                    out.clearRow = row;
                    return;
                }
                sweepCoreOnwards(body, other, from);
            }
            else
            {
                sweepCore(body, other, from);
            }
            if (_motion.time < out.time)
            {
                out.row = row;
                out.time = _motion.time;
                out.touchTime = touchTime;
                out.contact.copyFrom(_contact);
            }
        }

        // Sweeps the core from the time on at which the whole body touches. It is inside of the body, so it meets nothing before, and mostly it meets
        // the same thing soon after.
        private function sweepCoreOnwards(body:MovingBody, other:Body, from:Vector3D):void
        {
            _motion.earliest = _motion.time;
            _motion.latest = Math.min(1, _motion.time + SOON * body.core.slop / _length);
            sweepCore(body, other, from);
            _motion.latest = 1;
            if (_motion.time == RelativeMotion.NEVER)
            {
                sweepCore(body, other, from);
            }
            _motion.earliest = 0;
        }

        private function sweepCore(body:MovingBody, other:Body, from:Vector3D):void
        {
            sweep(body.core.at(_end), other, body.core.slop, _contact);
            // a sheet may be wholly under the ground at the beginning, and then it touches no surface
            if (_motion.time == RelativeMotion.NEVER && other.form == ModelShape.GROUND
                    && _seen.narrowPhase.areTouching(body.core.at(from), other))
            {
                _motion.time = 0;
                _contact.setNormal(0, 0, 0);
            }
        }

        // Finds when a body, which is at its end, first meets another. The motion receives the time, because V8 would make an object for a
        // Number that is returned.
        private function sweep(body:Body, other:Body, nearby:Number, contact:ContactPoint):void
        {
            _motion.time = RelativeMotion.NEVER;
            if (MovingBody.isNear(body, other, _motion, nearby))
            {
                _seen.narrowPhase.testsOf(body, other).findImpact(body, other, _motion, contact);
            }
        }
    }
}
