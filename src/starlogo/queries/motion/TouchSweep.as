package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.data.IntList;
    import starlogo.geometry.Tolerances;

    /**
     * Finds where a straight motion of a body first touches a row, for casts and moveUntilTouch. A row that the body would go into stops it. A row that
     * it only touches, leaves or runs along does not stop it, because the core of the body is swept (CoreSweep). At the beginning the body may overlap
     * the row (OverlapRecovery).
     *
     * @private
     */
    public final class TouchSweep
    {
        // The number of places that are tried in order to find one at which the two touch. A sweep may end some 30 gaps before a triangle of the ground.
        private static const STEPS_INTO_TOUCH:int = 64;

        // How often the way to where the core touches is halved. The rest is less than rounding.
        private static const HALVINGS:int = 40;

        private var _sweep:CoreSweep = new CoreSweep();
        private var _recovery:OverlapRecovery = new OverlapRecovery();

        // The row of a question, as a list; and how the beginning lifts the body, the plane of a deep overlap, and how the core meets the row.
        private var _rows:IntList = new IntList();
        private var _lift:StartLift = new StartLift();
        private var _planes:SlidePlanes = new SlidePlanes();
        private var _impact:Impact = new Impact();

        // The way from the computed end of a motion to where the core touches.
        private var _toCore:Vector3D = new Vector3D();

        /**
         * Computes how the beginning of a motion lifts a body out of all rows together.
         *
         * @param rows the rows
         * @param out receives the lift: 0 if the body overlaps nothing, or does not get free
         * @return whether there is a lift
         */
        public function findLift(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, out:StartLift):Boolean
        {
            out.clear();
            if (body.beginMotion(rows, from, motion))
            {
                _planes.begin(motion, SlideLimits.NONE);
                _recovery.leaveOverlaps(body, from, _planes, out);
            }
            return out.isLifted;
        }

        /**
         * Computes a motion that ends when it first touches a row, as if there were no others.
         *
         * @param from where it begins: not <code>out.place</code>, which is written before the end
         * @param motion the whole motion
         * @param lift the lift of <code>findLift()</code> with which it begins
         * @param out receives the answer. Rounding may hide the touch at its place: see <code>goIntoTouch()</code>
         */
        public function findTouch(body:MovingBody, row:int, from:Vector3D, motion:Vector3D, lift:StartLift, out:MotionResult):void
        {
            _lift.copyFrom(lift);
            findStop(body, row, from, motion, _lift, out);
            _lift.findEnd(from, motion, out.fraction, body.core.slop, out.place);
        }

        /**
         * Moves the end of a motion into the touch, on the side that the body comes from. Beyond a row without thickness the two would not touch, and
         * the body could not come back. So it tries several places, the outermost first: half of the gap across which the two still touch before the
         * contact. Rounding may hide the touch on a long way, and at an edge that the body meets at a flat angle. Then the touch is found between the
         * computed end and where the core touches the row, which may be much farther on: at a flat angle along the side of a tile.
         *
         * @param result an answer of <code>findTouch()</code> for this body, which a row stops. Its place changes
         */
        public function goIntoTouch(body:MovingBody, result:MotionResult):void
        {
            if (result.fraction == 0)
            {
                return;
            }
            _toCore.copyFrom(result.corePlace);
            _toCore.decrementBy(result.place);
            var step:Number = halfGapAt(result.place, body.extentWith(body.bodyOf(result.row)));
            result.contact.push(result.place, step);
            for (var i:int = 0; i < STEPS_INTO_TOUCH; i++)
            {
                if (body.touches(result.row, result.place))
                {
                    return;
                }
                result.contact.push(result.place, -step);
            }
            var free:Number = 0;
            var part:Number = 1;
            for (i = 0; i < HALVINGS; i++)
            {
                goAlong(result, (free + part) / 2);
                if (body.touches(result.row, result.place))
                {
                    part = (free + part) / 2;
                }
                else
                {
                    free = (free + part) / 2;
                }
            }
            goAlong(result, part);
        }

        // Goes a part of the way to where the core touches.
        private function goAlong(result:MotionResult, part:Number):void
        {
            var back:Number = 1 - part;
            var core:Vector3D = result.corePlace;
            result.place.setTo(core.x - back * _toCore.x, core.y - back * _toCore.y, core.z - back * _toCore.z);
        }

        // Finds whether and how a row stops a motion that begins with a lift. The lift receives what else the body is lifted out of. The result receives all
        // but its place.
        private function findStop(body:MovingBody, row:int, from:Vector3D, motion:Vector3D, lift:StartLift, out:MotionResult):void
        {
            _rows.count = 0;
            _rows.add(row);
            out.row = -1;
            out.fraction = 1;
            out.contact.setNormal(0, 0, 0);
            out.isDeep = out.isLifted = false;
            if (!body.beginMotion(_rows, from, motion))
            {
                lift.clear();
                return;
            }
            lift.place.copyFrom(from);
            if (lift.isLifted || !_sweep.findFirstIfFree(body, from, motion, _impact))
            {
                _planes.begin(motion, SlideLimits.NONE);
                _recovery.leaveOverlaps(body, from, _planes, lift);
                out.isDeep = _planes.count > 0;
                out.isLifted = lift.isLifted;
                out.row = _planes.findCrossed(out.contact);
                if (out.row >= 0)
                {
                    out.fraction = 0;
                    return;
                }
                _sweep.findObstacle(body, lift.place, motion, _impact);
            }
            if (_impact.row >= 0)
            {
                takeImpact(body, from, motion, lift, out);
            }
        }

        // Finds where the body touches what its core, after the lift, has met.
        private function takeImpact(body:MovingBody, from:Vector3D, motion:Vector3D, lift:StartLift, out:MotionResult):void
        {
            out.row = _impact.row;
            out.contact.copyFrom(_impact.contact);
            out.contact.depth = 0;
            var touchTime:Number = _sweep.findTouchTime(body, lift.place, motion, _impact);
            out.corePlace.setTo(lift.place.x + _impact.time * motion.x, lift.place.y + _impact.time * motion.y, lift.place.z + _impact.time * motion.z);
            // without the lift the body would have touched earlier
            var time:Number = touchTime + out.contact.along(lift.displacement) / _impact.along;
            out.fraction = time > 0 ? (time < 1 ? time : 1) : 0;
            if (-out.fraction * _impact.along < body.core.slop && body.touches(out.row, from))
            {
                // otherwise each motion against a wall would lead a little deeper
                out.fraction = 0;
            }
        }

        // At most half of the gap across which two bodies still touch at a place. Two spheres or points may have a narrower one.
        private static function halfGapAt(place:Vector3D, extent:Number):Number
        {
            return Tolerances.SURFACES / 4 * extent + Tolerances.PLACES / 2 * (Math.abs(place.x) + Math.abs(place.y) + Math.abs(place.z));
        }
    }
}
