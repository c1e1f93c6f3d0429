package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;
    import starlogo.geometry.Tolerances;

    /**
     * Finds where a straight motion of a body first touches a row, for casts and moveUntilTouch. A row that the body would go into stops it. A row that
     * it only touches, leaves or runs along does not stop it, because the core of the body is swept (CoreSweep).
     *
     * <p>The motion is tested from where a lift out of all rows together has led the body (CoreSweep.findStart). A row alone may lift it farther. But the
     * motion ends where it would end without lifts, though no deeper in what the body was lifted out of.</p>
     *
     * @private
     */
    public final class TouchSweep
    {
        // The number of places that are tried in order to find one at which the two touch. A sweep may end some 30 gaps before a triangle of the ground.
        private static const STEPS_INTO_TOUCH:int = 64;

        // How often the way to where the core touches is halved. The rest is less than rounding.
        private static const HALVINGS:int = 40;

        // If a motion leads this many slops deeper into what it was lifted out of, the body has left the surface. Otherwise its core would meet it.
        private static const SLOPS_TO_LEAVE:Number = 2;

        private var _sweep:CoreSweep = new CoreSweep();

        // The row of a question as a list, and how its motion starts.
        private var _rows:IntList = new IntList();
        private var _start:MotionStart = new MotionStart();

        // The way from the computed end of a motion to where the core touches.
        private var _toCore:Vector3D = new Vector3D();

        /**
         * Finds how a motion of a body from <code>body.from</code> starts among all rows near its way.
         *
         * @param out receives the answer. Its place is <code>body.from</code> if nothing lifts the body
         */
        public function findCommonStart(body:MovingBody, motion:Vector3D, out:MotionStart):void
        {
            _sweep.findStart(body, body.rows, body.from, motion, out);
        }

        /**
         * Finds whether and when a row stops a motion of a body from <code>body.from</code>, as if there were no others.
         *
         * @param motion the whole motion
         * @param common how it starts among all rows
         * @param out receives the answer. Rounding may hide the touch at its place: see <code>goIntoTouch()</code>
         * @return whether the start among all rows may change the answer: if the row alone lifts the body, or stops it at once in a shallow overlap
         */
        public function findTouch(body:MovingBody, row:int, motion:Vector3D, common:MotionStart, out:MotionResult):Boolean
        {
            _rows.count = 0;
            _rows.add(row);
            _sweep.findStop(body, _rows, common.place, motion, _start, out);
            if (out.row < 0)
            {
                out.contact.setNormal(0, 0, 0);
            }
            else if (!out.isDeep)
            {
                out.contact.depth = 0;
                leaveOutLift(motion, _start, out);
            }
            setEnd(body.from, motion, out.fraction, common, out.place);
            pushBack(body.from, _start, out.place);
            return !_start.place.equals(common.place) || (out.fraction == 0 && !out.isDeep);
        }

        /**
         * Sets where a fraction of a motion ends without lifts, but no deeper in what the body was lifted out of.
         *
         * @param common how the motion starts among all rows
         */
        public function setEnd(from:Vector3D, motion:Vector3D, fraction:Number, common:MotionStart, out:Vector3D):void
        {
            CoreSweep.setAlong(from, motion, fraction, out);
            pushBack(from, common, out);
        }

        /**
         * Moves the end of a motion into the touch, on the side that the body comes from. Beyond a row without thickness the two would not touch, and
         * the body could not come back. So it tries several places, the outermost first: half of the gap across which the two still touch before the
         * contact. Rounding may hide the touch on a long way, and at an edge that the body meets at a flat angle. Then the touch is found between the
         * computed end and where the core touches the row, which may be much farther on: at a flat angle along the side of a tile.
         *
         * @param touch an answer of <code>findTouch()</code> for this body, which a row stops. Its place changes
         */
        public function goIntoTouch(body:MovingBody, touch:MotionResult):void
        {
            if (touch.fraction == 0)
            {
                return;
            }
            var place:Vector3D = touch.place;
            _toCore.copyFrom(touch.corePlace);
            _toCore.decrementBy(place);
            var step:Number = halfGapAt(place, body.extentWith(body.bodyOf(touch.row)));
            touch.contact.push(place, step);
            for (var i:int = 0; i < STEPS_INTO_TOUCH; i++)
            {
                if (body.touches(touch.row, place))
                {
                    return;
                }
                touch.contact.push(place, -step);
            }
            var free:Number = 0;
            var touching:Number = 1;
            for (i = 0; i < HALVINGS; i++)
            {
                var middle:Number = (free + touching) / 2;
                setBefore(touch.corePlace, _toCore, 1 - middle, place);
                if (body.touches(touch.row, place))
                {
                    touching = middle;
                }
                else
                {
                    free = middle;
                }
            }
            setBefore(touch.corePlace, _toCore, 1 - touching, place);
        }

        // Takes the lift out of a time of touch: without it the body would have touched earlier.
        private static function leaveOutLift(motion:Vector3D, start:MotionStart, out:MotionResult):void
        {
            var from:Vector3D = start.core.body.from;
            var contact:ContactPoint = out.contact;
            var lift:Number = contact.normalX * (start.place.x - from.x) + contact.normalY * (start.place.y - from.y)
                + contact.normalZ * (start.place.z - from.z);
            var along:Number = contact.along(motion);
            out.fraction = Math.max(0, Math.min(1, out.fraction + lift / along));
            if (-out.fraction * along < start.core.slop && start.core.bodyTouches(out.row, from))
            {
                // otherwise each motion against a wall would lead a little deeper
                out.fraction = 0;
            }
        }

        // Pushes a place back where a body is deeper than it was at the beginning in what it was lifted out of. Without this, motions that are shorter than
        // the clearance of a lift would lead deeper each time.
        private static function pushBack(from:Vector3D, start:MotionStart, place:Vector3D):void
        {
            for (var i:int = 0; i < start.lifted.count; i++)
            {
                var contact:ContactPoint = start.lifted.contacts[i];
                var deeper:Number = contact.normalX * (from.x - place.x) + contact.normalY * (from.y - place.y) + contact.normalZ * (from.z - place.z);
                if (deeper > 0 && deeper < SLOPS_TO_LEAVE * start.core.slop)
                {
                    contact.push(place, deeper);
                }
            }
        }

        // Sets a place that is a fraction of a way before its end.
        private static function setBefore(end:Vector3D, way:Vector3D, fraction:Number, out:Vector3D):void
        {
            out.setTo(end.x - fraction * way.x, end.y - fraction * way.y, end.z - fraction * way.z);
        }

        // At most half of the gap across which two bodies still touch at a place. Two spheres or points may have a narrower one.
        private static function halfGapAt(place:Vector3D, extent:Number):Number
        {
            return Tolerances.SURFACES / 4 * extent + Tolerances.PLACES / 2 * (Math.abs(place.x) + Math.abs(place.y) + Math.abs(place.z));
        }
    }
}
