package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
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
        // The motion, the body's place at its end, the motion's length, and the contact that was found last.
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _end:Vector3D = new Vector3D();
        private var _length:Number = 0;
        private var _contact:ContactPoint = new ContactPoint();

        // Where a sweep begins again that has met what the core leaves.
        private var _beyond:Vector3D = new Vector3D();

        /**
         * Finds what the core meets first.
         *
         * @param body the body that moves. What it meets are its obstacles. Of rows that are met at the same time, the first one counts
         * @param from where the motion begins
         * @param out receives the answer, without the time of the touch
         * @return whether anything is met
         */
        public function findFirst(body:MovingBody, from:Vector3D, motion:Vector3D, out:Impact):Boolean
        {
            aim(from, motion);
            out.row = -1;
            out.time = RelativeMotion.NEVER;
            out.touchTime = NaN;
            out.isNormalFallback = false;
            for (var i:int = 0; i < body.obstacles.count; i++)
            {
                keepEarlier(body, body.obstacles.numbers[i], from, motion, out);
            }
            if (out.row < 0)
            {
                return false;
            }
            out.along = out.contact.along(motion);
            out.isNormalFallback = !isAgainst(out.along);
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
            findStop(body, body.bodyOf(row), from, motion);
            return _motion.time != RelativeMotion.NEVER;
        }

        /**
         * Finds when the whole body touches the row that the core meets first: earlier than the core, by how far the core is behind the body's surface at
         * the contact. But an inner face of a concave body touches later than the core's. There the whole body is swept too. If it touches elsewhere, the
         * core's time counts: this is no inner face.
         *
         * @param out what <code>findFirst()</code> has found; receives the time of the touch
         */
        public function findTouchTime(body:MovingBody, from:Vector3D, motion:Vector3D, out:Impact):void
        {
            var contact:ContactPoint = out.contact;
            var source:Body = body.source;
            var shrink:Number = body.core.shrink;
            var recess:Number = shrink / (1 - shrink) * (contact.normalX * (from.x + source.offsetX + out.time * motion.x - contact.x)
                    + contact.normalY * (from.y + source.offsetY + out.time * motion.y - contact.y)
                    + contact.normalZ * (from.z + source.offsetZ + out.time * motion.z - contact.z));
            out.touchTime = Math.max(0, Math.min(1, out.time + recess / out.along));
            if (recess < 0)
            {
                aim(from, motion);
                var whole:Body = body.wholeAt(_end);
                var other:Body = body.bodyOf(out.row);
                body.pairTestsFor(whole, other).findImpact(whole, other, _motion, null);
                var isExpected:Boolean = Math.abs(_motion.time - out.touchTime) <= out.touchTime - out.time;
                out.touchTime = isExpected ? _motion.time : out.time;
            }
        }

        private function aim(from:Vector3D, motion:Vector3D):void
        {
            _end.copyFrom(from);
            _end.incrementBy(motion);
            _motion.endAfter(motion.x, motion.y, motion.z);
            _length = Math.sqrt(motion.x * motion.x + motion.y * motion.y + motion.z * motion.z);
        }

        // Sweeps against a row. If the core meets it earlier than what was found before, it is the answer. A contact that does not point against the
        // motion counts a clearance later. So a corner of the core that enters a floor exactly between two tiles, along the side of one of them, is
        // stopped by the top of the other.
        private function keepEarlier(body:MovingBody, row:int, from:Vector3D, motion:Vector3D, out:Impact):void
        {
            findStop(body, body.bodyOf(row), from, motion);
            if (_motion.time == RelativeMotion.NEVER)
            {
                return;
            }
            var isNormalFallback:Boolean = _motion.time > 0 && !isAgainst(_contact.along(motion));
            var time:Number = _motion.time;
            var earliest:Number = out.time;
            if (isNormalFallback)
            {
                time += body.core.clearance / _length;
            }
            if (out.isNormalFallback)
            {
                earliest += body.core.clearance / _length;
            }
            if (time < earliest)
            {
                out.row = row;
                out.time = _motion.time;
                out.contact.copyFrom(_contact);
                out.isNormalFallback = isNormalFallback;
            }
        }

        // Finds when and how a body stops the core. If the first contact on the way does not point against the motion, the core leaves what it touches
        // there, and may enter another face at the same time: at the edge of a tile, its top. Then the sweep begins again, a clearance farther on.
        // A flat core may be past the body there.
        private function findStop(body:MovingBody, other:Body, from:Vector3D, motion:Vector3D):void
        {
            sweepCore(body, other, from);
            var isOnWay:Boolean = _motion.time > 0 && _motion.time != RelativeMotion.NEVER;
            if (!isOnWay || isAgainst(_contact.along(motion)) || body.core.isFlat)
            {
                return;
            }
            var part:Number = Math.min(1, _motion.time + body.core.clearance / _length);
            var rest:Number = 1 - part;
            _beyond.setTo(from.x + part * motion.x, from.y + part * motion.y, from.z + part * motion.z);
            _motion.endAfter(rest * motion.x, rest * motion.y, rest * motion.z);
            sweepCore(body, other, _beyond);
            _motion.endAfter(motion.x, motion.y, motion.z);
            if (_motion.time != RelativeMotion.NEVER)
            {
                _motion.time = part + rest * _motion.time;
            }
        }

        // Whether a contact points against the motion, whose component along its normal is given.
        private function isAgainst(along:Number):Boolean
        {
            return along < -SlidePlanes.PARALLEL_SINE * _length;
        }

        // Finds when and how the core first meets a body. The motion receives the time, because V8 would make an object for a Number that is
        // returned.
        private function sweepCore(body:MovingBody, other:Body, from:Vector3D):void
        {
            var core:Body = body.core.at(_end);
            _motion.time = RelativeMotion.NEVER;
            if (body.isNear(core, other, _motion))
            {
                body.pairTestsFor(core, other).findImpact(core, other, _motion, _contact);
            }
            // a sheet may be wholly under the ground at the beginning, and then it touches no surface
            if (_motion.time == RelativeMotion.NEVER && other.form == ModelShape.GROUND
                    && body.pairTestsFor(core, other).areTouching(body.core.at(from), other))
            {
                _motion.time = 0;
                _contact.setNormal(0, 0, 0);
            }
        }
    }
}
