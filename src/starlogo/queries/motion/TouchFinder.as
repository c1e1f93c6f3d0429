package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;
    import starlogo.data.SortableIntList;
    import starlogo.geometry.compareVectors;
    import starlogo.geometry.Tolerances;

    /**
     * Finds where a straight motion of a body first touches rows, for casts and moveUntilTouch, with a ShrunkSweep for each row. A row that the body
     * would go into stops it. A row that it only touches, leaves or runs along does not stop it, because the shrunk body is swept.
     *
     * <p>Each row is tested alone, from where the body begins. If the body overlaps one of them a little there, it is tested again, from the start to which
     * pushes out of all rows together lead the body (ShrunkSweep.begin). The answers are as without pushes: each push is taken out of the time
     * of a touch and of the end of the motion. But the end is no deeper in what the body was pushed out of.</p>
     *
     * @private
     */
    public final class TouchFinder
    {
        // The number of places that are tried in order to find one at which the two touch, half a gap apart. A sweep may end some 30 gaps before a triangle
        // of the ground, and some 40 before the touch of a point.
        private static const STEPS_INTO_TOUCH:int = 128;

        // How often the way to where the shrunk body touches is halved. The rest is less than rounding.
        private static const HALVINGS:int = 40;

        // If a motion leads this many slops deeper into what it was pushed out of, the body has left the surface. Otherwise the shrunk body would
        // meet it.
        private static const SLOPS_TO_LEAVE:Number = 2;

        // The motion among all rows.
        private var _sweepOfAll:ShrunkSweep = new ShrunkSweep(new Depenetration());

        // One row, and the motion past it.
        private var _row:IntList = new IntList();
        private var _sweepOfRow:ShrunkSweep = new ShrunkSweep(new Depenetration());

        // The results, whose memory is used again, and the indices of the results that count, with the times as keys. A free motion has the first result.
        private var _results:Vector.<MotionResult> = new <MotionResult>[new MotionResult()];
        private var _touches:SortableIntList = new SortableIntList();

        /**
         * Finds the rows of a body that stop its motion, each as if the others were not there. Those with the same time keep their order.
         *
         * @param body has the motion, and the rows near its way
         * @return the first of these touches, or if there are none, the result of the free motion
         */
        public function findTouches(body:MovingBody):MotionResult
        {
            // the first pass is without pushes out of all rows, so setEnd() takes none back
            _sweepOfAll.pushes.clear();
            if (addTouches(body, body.from))
            {
                // a floor may be many rows: what is pushed out of one of them does not run into the next
                _sweepOfAll.begin(body, body.rows, body.from, body.motion);
                if (compareVectors(_sweepOfAll.start, body.from) != 0)
                {
                    addTouches(body, _sweepOfAll.start);
                }
            }
            if (count > 0)
            {
                _touches.sortFirst(count);
                return touchAt(0);
            }
            var free:MotionResult = _results[0];
            free.row = -1;
            free.fraction = 1;
            free.startsPenetrating = false;
            setEnd(body, 1, free.place);
            return free;
        }

        /** How many touches were found. */
        public function get count():int
        {
            return _touches.count;
        }

        /** A touch that was found. They are sorted by time. */
        public function touchAt(index:int):MotionResult
        {
            return _results[_touches.values[index]];
        }

        // Adds the rows that stop the body if it starts at a place. Returns whether another start may change the answer.
        private function addTouches(body:MovingBody, start:Vector3D):Boolean
        {
            var mayPush:Boolean = false;
            _touches.count = 0;
            // what stops the body at once does not end the loop, because a row behind it may push the body
            for (var i:int = 0; i < body.rows.count; i++)
            {
                if (count == _results.length)
                {
                    _results.push(new MotionResult());
                }
                var touch:MotionResult = _results[count];
                var isPushed:Boolean = findTouch(body, start, body.rows.values[i], touch);
                // the row alone pushes the body, or stops it at once in a shallow overlap
                mayPush ||= isPushed || (touch.fraction == 0 && !touch.startsPenetrating);
                if (touch.hasContact)
                {
                    _touches.add(count, touch.fraction);
                }
            }
            return mayPush;
        }

        // Finds whether and when a row stops the body, as if there were no others. The row alone may push the body farther from where it starts. Rounding
        // may hide the touch at its place: see moveIntoTouch. Returns whether the row pushes the body.
        private function findTouch(body:MovingBody, start:Vector3D, row:int, out:MotionResult):Boolean
        {
            _row.count = 0;
            _row.add(row);
            _sweepOfRow.findStop(body, _row, start, body.motion, out);
            if (out.hasContact)
            {
                if (!out.startsPenetrating)
                {
                    out.contact.depth = 0;
                    leaveOutPush(body, out);
                }
                setEnd(body, out.fraction, out.place);
                pushBack(body.from, _sweepOfRow, out.place);
            }
            return compareVectors(_sweepOfRow.start, start) != 0;
        }

        /**
         * Moves the end of a motion into the touch, on the side that the body comes from. Beyond a row without thickness the two would not touch, and
         * the body could not come back. So it tries several places, the outermost first: half of the gap across which the two still touch before the
         * contact. Rounding may hide the touch on a long way, and at an edge that the body meets at a grazing angle. Then the touch is found between the
         * computed end and where the shrunk body touches the row, which may be much farther on: at a grazing angle along the side of a tile.
         *
         * @param touch a result for this body, which a row stops. Its place changes
         */
        public function moveIntoTouch(body:MovingBody, touch:MotionResult):void
        {
            if (touch.fraction == 0)
            {
                return;
            }
            var place:Vector3D = touch.place;
            var end:Vector3D = touch.shrunkPlace;
            var dx:Number = end.x - place.x;
            var dy:Number = end.y - place.y;
            var dz:Number = end.z - place.z;
            var step:Number = halfGapAt(place, body.extentWith(body.bodyOf(touch.row)));
            touch.contact.movePoint(place, step);
            for (var i:int = 0; i < STEPS_INTO_TOUCH; i++)
            {
                if (body.touches(touch.row, place))
                {
                    return;
                }
                touch.contact.movePoint(place, -step);
            }
            var free:Number = 0;
            var touching:Number = 1;
            // fractions are counted from where the shrunk body touches backwards, so that the last place is exactly there
            for (i = 0; i < HALVINGS; i++)
            {
                var middle:Number = (free + touching) / 2;
                place.setTo(end.x + (middle - 1) * dx, end.y + (middle - 1) * dy, end.z + (middle - 1) * dz);
                if (body.touches(touch.row, place))
                {
                    touching = middle;
                }
                else
                {
                    free = middle;
                }
            }
            place.setTo(end.x + (touching - 1) * dx, end.y + (touching - 1) * dy, end.z + (touching - 1) * dz);
        }

        // Takes the push out of a time of touch: without it the body would have touched earlier.
        private function leaveOutPush(body:MovingBody, out:MotionResult):void
        {
            var from:Vector3D = body.from;
            var start:Vector3D = _sweepOfRow.start;
            var contact:ContactPoint = out.contact;
            var push:Number = contact.normalX * (start.x - from.x) + contact.normalY * (start.y - from.y) + contact.normalZ * (start.z - from.z);
            var along:Number = contact.along(body.motion);
            out.fraction = Math.max(0, Math.min(1, out.fraction + push / along));
            if (-out.fraction * along < _sweepOfRow.shrunk.slop && _sweepOfRow.shrunk.fullBodyTouches(out.row, from))
            {
                // otherwise each motion against a wall would lead a little deeper
                out.fraction = 0;
            }
        }

        // Sets where the body is at a time of the motion without pushes, but no deeper in what the body was pushed out of at its start.
        private function setEnd(body:MovingBody, time:Number, out:Vector3D):void
        {
            ShrunkSweep.setAlong(body.from, body.motion, time, out);
            pushBack(body.from, _sweepOfAll, out);
        }

        // Pushes a place back where a body is deeper than it was at the beginning in what it was pushed out of. Without this, motions that are shorter than
        // the clearance of a push would lead deeper each time.
        private static function pushBack(from:Vector3D, sweep:ShrunkSweep, place:Vector3D):void
        {
            for (var i:int = 0; i < sweep.pushes.count; i++)
            {
                var contact:ContactPoint = sweep.pushes.contacts[i];
                var deeper:Number = contact.normalX * (from.x - place.x) + contact.normalY * (from.y - place.y) + contact.normalZ * (from.z - place.z);
                if (deeper > 0 && deeper < SLOPS_TO_LEAVE * sweep.shrunk.slop)
                {
                    contact.movePoint(place, deeper);
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
