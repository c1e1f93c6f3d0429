package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.pairs.PairTests;

    use namespace engine;

    /**
     * Finds what stops a body on a straight motion, and when. It sweeps the body's core, which does not meet what the body only touches, leaves or runs
     * along.
     *
     * <p>docs/mover.md derives the quantities.</p>
     *
     * @private
     */
    public final class CoreSweep
    {
        // How the core meets one row.
        private var _met:Impact = new Impact();

        // A sweep, the place of the body at its end, and the place where a second sweep begins.
        private var _sweep:RelativeMotion = new RelativeMotion();
        private var _end:Vector3D = new Vector3D();
        private var _beyond:Vector3D = new Vector3D();

        /**
         * Finds which obstacle of a body its core meets first. Of obstacles with the same <code>comparedTime</code>, the first one in their order counts.
         *
         * @param from where the motion begins
         * @param out receives the answer
         * @param countsInside as in findStop
         * @return whether anything is met
         */
        public function findFirst(body:MovingBody, from:Vector3D, motion:Vector3D, out:Impact, countsInside:Boolean = false):Boolean
        {
            out.row = -1;
            out.time = out.comparedTime = RelativeMotion.NEVER;
            for (var i:int = 0; i < body.obstacles.count && out.comparedTime > 0; i++)
            {
                if (findStop(body, body.obstacles.numbers[i], from, motion, _met, countsInside) && _met.comparedTime < out.comparedTime)
                {
                    out.copyFrom(_met);
                }
            }
            if (out.row < 0)
            {
                return false;
            }
            if (out.isNormalFallback)
            {
                out.contact.setNormal(-motion.x, -motion.y, -motion.z);
                out.contact.normalise();
                out.along = -motion.length;
            }
            return true;
        }

        /**
         * Finds what stops the core first, if it overlaps nothing where the motion begins: then nothing stops it at once. Flat bodies are
         * not decided here, nor motions that a one-way obstacle may stop first.
         *
         * @param out receives the answer of <code>findFirst()</code>
         * @return whether the core certainly overlaps nothing
         */
        public function findFirstIfFree(body:MovingBody, from:Vector3D, motion:Vector3D, out:Impact):Boolean
        {
            return !body.core.isFlat && (!findFirst(body, from, motion, out, true) || out.time > 0 && !body.isOneWay(out.row));
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

        /**
         * Finds when the whole body touches the row that its core has met. The body touches it earlier, because its surface is in front of the core's at
         * the contact. Only an inner face of a concave body is behind the core's, and touches later. There the body is swept too. Its time counts unless
         * it is farther from the expected time than the core's, because then the body touches elsewhere.
         *
         * @param impact what <code>findFirst()</code> has found
         */
        public function findTouchTime(body:MovingBody, from:Vector3D, motion:Vector3D, impact:Impact):Number
        {
            var contact:ContactPoint = impact.contact;
            var source:Body = body.source;
            var shrink:Number = body.core.shrink;
            var recess:Number = shrink / (1 - shrink) * (contact.normalX * (from.x + source.offsetX + impact.time * motion.x - contact.x)
                    + contact.normalY * (from.y + source.offsetY + impact.time * motion.y - contact.y)
                    + contact.normalZ * (from.z + source.offsetZ + impact.time * motion.z - contact.z));
            var expected:Number = Math.max(0, Math.min(1, impact.time + recess / impact.along));
            if (!(recess < 0))
            {
                return expected;
            }
            var whole:Body = body.wholeAt(endOf(from, motion));
            var other:Body = body.bodyOf(impact.row);
            _sweep.endAfter(motion.x, motion.y, motion.z);
            body.pairTestsFor(whole, other).findImpact(whole, other, _sweep, null);
            return Math.abs(_sweep.time - expected) <= expected - impact.time ? _sweep.time : impact.time;
        }

        /**
         * Finds when and how a row stops the core. If the first contact does not point against the motion, the core leaves there what it touches. At the
         * same time it may enter another face, as the top of a tile at its edge. So it is swept again from a clearance farther on. A flat core may be past
         * a sheet there, so it is not swept again.
         *
         * @param out receives the answer
         * @param countsInside whether the row stops the core at the beginning if it is inside of the row there, or has the row inside
         * @return whether the row stops it
         */
        public function findStop(body:MovingBody, row:int, from:Vector3D, motion:Vector3D, out:Impact, countsInside:Boolean = false):Boolean
        {
            var end:Vector3D = endOf(from, motion);
            _sweep.endAfter(motion.x, motion.y, motion.z);
            if (!sweepCore(body, row, from, end, _sweep, out.contact, countsInside))
            {
                return false;
            }
            var length:Number = motion.length;
            var clearancePart:Number = body.core.clearance / length;
            var against:Number = -SlidePlanes.PARALLEL_SINE * length;
            out.time = _sweep.time;
            if (out.time > 0 && !(out.contact.along(motion) < against) && !body.core.isFlat)
            {
                var part:Number = Math.min(1, out.time + clearancePart);
                var rest:Number = 1 - part;
                _beyond.setTo(from.x + part * motion.x, from.y + part * motion.y, from.z + part * motion.z);
                _sweep.endAfter(rest * motion.x, rest * motion.y, rest * motion.z);
                if (!sweepCore(body, row, _beyond, end, _sweep, out.contact, false))
                {
                    return false;
                }
                out.time = part + rest * _sweep.time;
            }
            out.row = row;
            out.along = out.contact.along(motion);
            out.isNormalFallback = !(out.along < against);
            out.comparedTime = out.isNormalFallback && out.time > 0 ? out.time + clearancePart : out.time;
            return true;
        }

        // Finds when and how the core first meets a row on a motion, which receives the time. Returns whether it meets the row.
        private static function sweepCore(body:MovingBody, row:int, from:Vector3D, end:Vector3D, motion:RelativeMotion, out:ContactPoint,
                countsInside:Boolean):Boolean
        {
            var core:Body = body.core.at(end);
            var other:Body = body.bodyOf(row);
            var isInside:Boolean = false;
            motion.time = RelativeMotion.NEVER;
            if (body.isNear(core, other, motion))
            {
                var tests:PairTests = body.pairTestsFor(core, other);
                if (countsInside)
                {
                    isInside = tests.findEntry(core, other, motion, out);
                }
                else
                {
                    tests.findImpact(core, other, motion, out);
                    // a sheet may be wholly under the ground at the beginning, and then it touches no surface
                    isInside = motion.time == RelativeMotion.NEVER && other.form == ModelShape.GROUND && tests.areTouching(body.core.at(from), other);
                }
            }
            if (isInside)
            {
                motion.time = 0;
                out.setNormal(0, 0, 0);
            }
            return motion.time != RelativeMotion.NEVER;
        }

        // Where a motion ends. It is valid until the next call.
        private function endOf(from:Vector3D, motion:Vector3D):Vector3D
        {
            _end.copyFrom(from);
            _end.incrementBy(motion);
            return _end;
        }
    }
}
