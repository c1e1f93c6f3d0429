package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;
    import starlogo.geometry.Tolerances;

    /**
     * Moves a body straight on among rows of a table, until it touches one of them. A row that it would go into stops it. A row that it only
     * touches, leaves or runs along never stops it, because the core of the body is swept (CoreSweep). At the beginning it may overlap rows
     * (OverlapRecovery). The Slider moves a body along what it meets.
     *
     * @private
     */
    public final class Mover
    {
        // The number of places that are tried in order to find one at which the two touch. A sweep may end some 30 gaps before a triangle of
        // the ground.
        private static const STEPS_INTO_TOUCH:int = 64;

        private var _sweep:CoreSweep = new CoreSweep();
        private var _recovery:OverlapRecovery = new OverlapRecovery();

        // How the beginning lifts the body, the planes of what it overlaps deeply, and what its core meets first.
        private var _lift:StartLift = new StartLift();
        private var _planes:SlidePlanes = new SlidePlanes();
        private var _impact:Impact = new Impact();

        /**
         * Computes how the beginning of a motion lifts a body out of rows, all together.
         *
         * @param rows the rows
         * @param out receives the lift: 0 if the body overlaps nothing, or does not get free
         * @return whether there is a lift
         */
        public function findLift(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, out:StartLift):Boolean
        {
            out.clear();
            body.beginMotion(rows, from, motion);
            if (_planes.begin(motion, SlideLimits.NONE))
            {
                _recovery.leaveOverlaps(body, from, _planes, out);
            }
            return out.isLifted;
        }

        /**
         * Computes a motion that ends when it first touches a row.
         *
         * @param rows the rows that may be in its way
         * @param from where it begins: not <code>out.place</code>, which is written before the end
         * @param motion the whole motion
         * @param lift the lift of <code>findLift()</code> with which it begins
         * @param out receives the answer. Rounding may hide the touch at its place: see <code>goIntoTouch()</code>
         */
        public function findTouch(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, lift:StartLift, out:MotionResult):void
        {
            _lift.copyFrom(lift);
            findFirstTouch(body, rows, from, motion, _lift, out);
            goAlong(from, motion, out.fraction, _lift, out.place);
        }

        /**
         * Moves the end of a motion into the touch, on the side that it comes from. If it went beyond a row without thickness, the two would not
         * touch, and it could not come back. It tries several places. The first is half a tolerance before the contact. The tolerance is the
         * distance across which the two still touch. On a long way rounding may hide the touch. Then the body ends where its core touches the row.
         *
         * @param result an answer of <code>findTouch()</code> for this body, which a row stops. Its place changes
         */
        public function goIntoTouch(body:MovingBody, result:MotionResult):void
        {
            if (result.fraction == 0)
            {
                return;
            }
            var half:Number = halfToleranceAt(result.place, body.extentWith(body.bodyOf(result.row)));
            result.contact.push(result.place, half);
            for (var i:int = 0; i < STEPS_INTO_TOUCH; i++)
            {
                if (body.touches(result.row, result.place))
                {
                    return;
                }
                result.contact.push(result.place, -half);
            }
            result.place.copyFrom(result.corePlace);
        }

        /**
         * Computes a motion that ends the clearance before it first touches a row.
         *
         * @param rows the rows that may be in its way
         * @param from where it begins
         * @param motion the whole motion
         * @param out receives the answer of <code>findTouch()</code> without a lift, but its place is the clearance before the touch. Its fraction
         *     is that of the touch
         */
        public function goBeforeTouch(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, out:MotionResult):void
        {
            _lift.clear();
            findFirstTouch(body, rows, from, motion, _lift, out);
            var part:Number = out.row >= 0 && out.fraction > 0 ? Math.max(0, out.fraction + body.core.clearance / out.along) : out.fraction;
            goAlong(from, motion, part, _lift, out.place);
        }

        /** Whether a body would go into a row on a straight motion. */
        public function meets(body:MovingBody, row:int, from:Vector3D, motion:Vector3D):Boolean
        {
            body.beginMotion(body.rows, from, motion);
            return _sweep.findStop(body, row, from, motion, _impact);
        }

        // Finds where a straight motion that begins with a lift first touches a row. The lift receives what else the body is lifted out of. The
        // result receives all but its place.
        private function findFirstTouch(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, lift:StartLift, out:MotionResult):void
        {
            out.row = -1;
            out.fraction = 1;
            out.contact.setNormal(0, 0, 0);
            out.isDeep = out.isLifted = false;
            if (!(motion.lengthSquared > Tolerances.VANISHING))
            {
                lift.clear();
                return;
            }
            body.beginMotion(rows, from, motion);
            if (!lift.isLifted && beginsFree(body, from, motion, _impact))
            {
                if (_impact.row >= 0)
                {
                    lift.place.copyFrom(from);
                    takeImpact(body, from, motion, lift, _impact, out);
                }
                return;
            }
            _planes.begin(motion, SlideLimits.NONE);
            _recovery.leaveOverlaps(body, from, _planes, lift);
            out.isDeep = _planes.count > 0;
            out.isLifted = lift.isLifted;
            var crossed:int = _planes.findCrossed();
            if (crossed >= 0)
            {
                out.contact.copyFrom(_planes.contacts[crossed]);
                // the plane stands for all triangles of the row
                out.contact.triangle = -1;
                out.row = _planes.rows[crossed];
                out.fraction = 0;
            }
            else if (_sweep.findObstacle(body, lift.place, motion, _impact))
            {
                takeImpact(body, from, motion, lift, _impact, out);
            }
        }

        // Whether the core touches nothing where a motion begins, so that what it meets first decides. The last argument receives that. One-way rows and
        // flat bodies are not decided here. A first touch after the beginning shows that no surfaces touch there.
        private function beginsFree(body:MovingBody, from:Vector3D, motion:Vector3D, first:Impact):Boolean
        {
            if (body.core.isFlat || _sweep.findFirst(body, from, motion, first) && first.time == 0)
            {
                return false;
            }
            for (var i:int = 0; i < body.obstacles.count; i++)
            {
                var row:int = body.obstacles.numbers[i];
                if (body.isOneWay(row) || body.isCoreInside(row, from))
                {
                    return false;
                }
            }
            return true;
        }

        // Finds the touch of a motion whose core, lifted, has met an impact.
        private function takeImpact(body:MovingBody, from:Vector3D, motion:Vector3D, lift:StartLift, impact:Impact, out:MotionResult):void
        {
            out.row = impact.row;
            out.along = impact.along;
            out.contact.copyFrom(impact.contact);
            out.contact.depth = 0;
            _sweep.findTouchTime(body, lift.place, motion, impact);
            out.corePlace.setTo(lift.place.x + impact.time * motion.x, lift.place.y + impact.time * motion.y, lift.place.z + impact.time * motion.z);
            // without the lift the body would have touched earlier
            var time:Number = impact.touchTime + out.contact.along(lift.displacement) / impact.along;
            out.fraction = time > 0 ? (time < 1 ? time : 1) : 0;
            if (-out.fraction * impact.along < body.core.slop && body.touches(out.row, from))
            {
                out.fraction = 0;
            }
        }

        /**
         * Finds the place at a part of a motion from its beginning before the lift, but no deeper in what the body was lifted out of. Without this,
         * motions that are shorter than the lift's clearance would lead deeper each time.
         */
        public static function goAlong(from:Vector3D, motion:Vector3D, part:Number, lift:StartLift, out:Vector3D):void
        {
            out.setTo(from.x + part * motion.x, from.y + part * motion.y, from.z + part * motion.z);
            for (var i:int = 0; i < lift.count; i++)
            {
                var contact:ContactPoint = lift.contacts[i];
                var deeper:Number = contact.normalX * (from.x - out.x) + contact.normalY * (from.y - out.y) + contact.normalZ * (from.z - out.z);
                if (deeper > 0 && deeper < lift.mostDepth)
                {
                    contact.push(out, deeper);
                }
            }
        }

        // Half of the gap across which two bodies still touch, at a place. It does not apply to spheres and points.
        private static function halfToleranceAt(place:Vector3D, extent:Number):Number
        {
            return Tolerances.SURFACES / 4 * extent + Tolerances.PLACES / 2 * (Math.abs(place.x) + Math.abs(place.y) + Math.abs(place.z));
        }
    }
}
