package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.rays.Hits;
    import starlogo.queries.trees.Collector;

    use namespace engine;

    /**
     * Finds where a straight motion of a body first touches rows, for casts and moveUntilTouch. A row that the body would go into stops it. A row that
     * it only touches, leaves or runs along does not stop it, because the core of the body is swept (CoreSweep).
     *
     * <p>The motion is tested from where pushes out of all rows together have led the body (CoreSweep.startMotion). A row alone may push it farther. But the
     * motion ends where it would end without pushes, though no deeper in what the body was pushed out of.</p>
     *
     * @private
     */
    public final class TouchSweep
    {
        // The number of places that are tried in order to find one at which the two touch, half a gap apart. A sweep may end some 30 gaps before a triangle
        // of the ground, and some 40 before the touch of a point.
        private static const STEPS_INTO_TOUCH:int = 128;

        // How often the way to where the core touches is halved. The rest is less than rounding.
        private static const HALVINGS:int = 40;

        // If a motion leads this many slops deeper into what it was pushed out of, the body has left the surface. Otherwise its core would meet it.
        private static const SLOPS_TO_LEAVE:Number = 2;

        private var _seen:SeenAgents;
        private var _sweep:CoreSweep = new CoreSweep();

        // The state of a motion among all rows.
        private var _stateOfAll:MotionState = new MotionState();

        // A row alone as a list, the state of the motion with it, and the answer.
        private var _rowAlone:IntList = new IntList();
        private var _stateOfRow:MotionState = new MotionState();
        private var _touch:MotionResult = new MotionResult();

        // The way from the computed end of a motion to where the core touches.
        private var _toCore:Vector3D = new Vector3D();

        /** @param seen the agents that the motions are among */
        public function TouchSweep(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Finds the rows near the way of a body from <code>body.from</code> that stop a motion, each as if the others were not there.
         *
         * @param motion the whole motion
         * @param wanted how many of the first ones are wanted, or Collector.ALL
         * @param hits receives how the body touches each row
         * @param first receives the answer for the first row, or the free end of the motion
         * @return the wanted rows, with their times as keys
         */
        public function findTouches(body:MovingBody, motion:Vector3D, wanted:int, hits:Hits, first:MotionResult):Collector
        {
            var collector:Collector = _seen.beginSearch(wanted, Infinity, null, null);
            _stateOfAll.startPlace.copyFrom(body.from);
            _stateOfAll.pushes.clear();
            if (addTouches(body, motion, _stateOfAll, collector, hits, first))
            {
                // a floor may be many rows: what is pushed out of one of them does not run into the next
                _sweep.startMotion(body, body.rows, body.from, motion, _stateOfAll);
                if (!_stateOfAll.startPlace.equals(body.from))
                {
                    collector = _seen.beginSearch(wanted, Infinity, null, null);
                    addTouches(body, motion, _stateOfAll, collector, hits, first);
                }
            }
            if (!first.isStopped)
            {
                setEnd(body.from, motion, 1, _stateOfAll, first.place);
            }
            return collector;
        }

        // Adds the rows that stop the body. The state among all rows has the start. Returns whether another start may change the answer.
        private function addTouches(body:MovingBody, motion:Vector3D, ofAll:MotionState, collector:Collector, hits:Hits, first:MotionResult):Boolean
        {
            var mayPush:Boolean = false;
            hits.begin();
            first.row = -1;
            first.fraction = 1;
            first.isDeep = false;
            // what stops the body at once does not end the loop, because a row behind it may push the body
            for (var i:int = 0; i < body.rows.count; i++)
            {
                var row:int = body.rows.numbers[i];
                findTouch(body, row, motion, ofAll, _stateOfRow, _touch);
                mayPush ||= mayPushChange(_stateOfRow, ofAll, _touch);
                if (_touch.isStopped)
                {
                    collector.add(row, _touch.fraction);
                    hits.add(row, _touch.fraction).copyFrom(_touch.contact);
                    if (!first.isStopped || _touch.fraction < first.fraction)
                    {
                        first.copyFrom(_touch);
                    }
                }
            }
            return mayPush;
        }

        // Finds whether and when a row stops a motion of a body from where the body begins, as if there were no others. The state among all rows has the
        // start, and that of the row receives how the motion starts with it alone. Rounding may hide the touch at its place: see goIntoTouch.
        private function findTouch(body:MovingBody, row:int, motion:Vector3D, ofAll:MotionState, ofRow:MotionState, out:MotionResult):void
        {
            _rowAlone.count = 0;
            _rowAlone.add(row);
            _sweep.findStop(body, _rowAlone, ofAll.startPlace, motion, ofRow, out);
            if (out.isStopped)
            {
                if (!out.isDeep)
                {
                    out.contact.depth = 0;
                    leaveOutPush(motion, ofRow, out);
                }
                setEnd(body.from, motion, out.fraction, ofAll, out.place);
                pushBack(body.from, ofRow, out.place);
            }
        }

        // Whether a start that pushes out of all rows lead to may change the answer for a row: the row alone pushes the body, or stops it at once in a
        // shallow overlap.
        private static function mayPushChange(ofRow:MotionState, ofAll:MotionState, touch:MotionResult):Boolean
        {
            return !ofRow.startPlace.equals(ofAll.startPlace) || (touch.fraction == 0 && !touch.isDeep);
        }

        /**
         * Moves the end of a motion into the touch, on the side that the body comes from. Beyond a row without thickness the two would not touch, and
         * the body could not come back. So it tries several places, the outermost first: half of the gap across which the two still touch before the
         * contact. Rounding may hide the touch on a long way, and at an edge that the body meets at a grazing angle. Then the touch is found between the
         * computed end and where the core touches the row, which may be much farther on: at a grazing angle along the side of a tile.
         *
         * @param touch an answer for this body, which a row stops. Its place changes
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
            // times are counted from where the core touches backwards, so that the last one is exactly there
            for (i = 0; i < HALVINGS; i++)
            {
                var middle:Number = (free + touching) / 2;
                CoreSweep.setAlong(touch.corePlace, _toCore, middle - 1, place);
                if (body.touches(touch.row, place))
                {
                    touching = middle;
                }
                else
                {
                    free = middle;
                }
            }
            CoreSweep.setAlong(touch.corePlace, _toCore, touching - 1, place);
        }

        // Takes the push out of a time of touch: without it the body would have touched earlier.
        private static function leaveOutPush(motion:Vector3D, state:MotionState, out:MotionResult):void
        {
            var from:Vector3D = state.core.body.from;
            var contact:ContactPoint = out.contact;
            var push:Number = contact.normalX * (state.startPlace.x - from.x) + contact.normalY * (state.startPlace.y - from.y)
                + contact.normalZ * (state.startPlace.z - from.z);
            var along:Number = contact.along(motion);
            out.fraction = Math.max(0, Math.min(1, out.fraction + push / along));
            if (-out.fraction * along < state.core.slop && state.core.bodyTouches(out.row, from))
            {
                // otherwise each motion against a wall would lead a little deeper
                out.fraction = 0;
            }
        }

        // Sets where a fraction of a motion ends without pushes, but no deeper in what the body was pushed out of among all rows.
        private static function setEnd(from:Vector3D, motion:Vector3D, fraction:Number, ofAll:MotionState, out:Vector3D):void
        {
            CoreSweep.setAlong(from, motion, fraction, out);
            pushBack(from, ofAll, out);
        }

        // Pushes a place back where a body is deeper than it was at the beginning in what it was pushed out of. Without this, motions that are shorter than
        // the clearance of a push would lead deeper each time.
        private static function pushBack(from:Vector3D, state:MotionState, place:Vector3D):void
        {
            for (var i:int = 0; i < state.pushes.count; i++)
            {
                var contact:ContactPoint = state.pushes.contacts[i];
                var deeper:Number = contact.normalX * (from.x - place.x) + contact.normalY * (from.y - place.y) + contact.normalZ * (from.z - place.z);
                if (deeper > 0 && deeper < SLOPS_TO_LEAVE * state.core.slop)
                {
                    contact.push(place, deeper);
                }
            }
        }

        // At most half of the gap across which two bodies still touch at a place. Two spheres or points may have a narrower one.
        private static function halfGapAt(place:Vector3D, extent:Number):Number
        {
            return Tolerances.SURFACES / 4 * extent + Tolerances.PLACES / 2 * (Math.abs(place.x) + Math.abs(place.y) + Math.abs(place.z));
        }
    }
}
