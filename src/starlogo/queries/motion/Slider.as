package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;

    /**
     * Moves a body among rows of a table, along the rows that it meets. It begins like a motion of the Mover.
     *
     * @private
     */
    public final class Slider
    {
        // If the next row is met within this many slops, this is the same corner.
        private static const SAME_CORNER:Number = 4;

        // A normal is vertical if the square of its horizontal part is at most this. The rest is a rounding error.
        private static const VERTICAL_NORMAL:Number = 1e-20;

        // A slide ends after this many iterations.
        private static const MOST_ITERATIONS:int = 8;

        private var _sweep:CoreSweep = new CoreSweep();
        private var _recovery:OverlapRecovery = new OverlapRecovery();

        // What is left of the motion, what is met first on that, and what is met first without one of the planes.
        private var _rest:SlidePlanes = new SlidePlanes();
        private var _impact:Impact = new Impact();
        private var _tried:Impact = new Impact();

        // How the beginning lifts the body. A slide goes on from there.
        private var _lift:StartLift = new StartLift();

        /**
         * Computes a motion that slides along what it meets.
         *
         * @param rows the rows that may be in its way
         * @param from where it begins
         * @param motion the whole motion
         * @param limits how it may go
         * @param out receives the answer
         */
        public function slide(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, limits:SlideLimits, out:SlideResult):void
        {
            var place:Vector3D = out.place;
            out.fraction = 1;
            out.metWall = false;
            out.floor.setNormal(0, 0, -1);
            out.floorRow = -1;
            body.beginMotion(rows, from, motion);
            if (!_rest.begin(motion, limits))
            {
                place.copyFrom(from);
                place.incrementBy(motion);
                return;
            }
            _lift.clear();
            _recovery.leaveOverlaps(body, from, _rest, _lift);
            place.copyFrom(_lift.place);
            var whole:Number = _rest.length;
            _rest.project();
            for (var iterations:int = 0; iterations < MOST_ITERATIONS && _rest.length > 0; iterations++)
            {
                if (!_sweep.findObstacle(body, place, _rest.motion, _impact))
                {
                    _rest.advance(place, 1);
                    break;
                }
                goToTouch(body, place, _impact);
                noteFloor(_impact, out);
                if (_impact.contact.normalZ < limits.walkableZ)
                {
                    out.metWall = true;
                    standUp(_impact.contact);
                }
                dropNeedless(body, place, _rest.add(_impact.contact, _impact.row));
                _rest.project();
            }
            out.fraction = _rest.gone < whole ? _rest.gone / whole : 1;
        }

        // Moves a slide to the clearance before the touch of what its core has met. If that is not in the present corner, another corner begins.
        private function goToTouch(body:MovingBody, place:Vector3D, impact:Impact):void
        {
            if (!isSameCorner(body, impact))
            {
                _rest.beginCorner();
            }
            _sweep.findTouchTime(body, place, _rest.motion, impact);
            _rest.advance(place, Math.max(impact.touchTime + body.core.clearance / impact.along, 0));
        }

        // Keeps the most level surface that a slide has met.
        private static function noteFloor(impact:Impact, out:SlideResult):void
        {
            if (!impact.isNormalFallback && (out.floorRow < 0 || impact.contact.normalZ > out.floor.normalZ))
            {
                out.floor.copyFrom(impact.contact);
                out.floorRow = impact.row;
            }
        }

        // Turns a contact that is too steep into an upright wall. The rest of the motion becomes level, because the slope would stop a motion up
        // or down.
        private function standUp(contact:ContactPoint):void
        {
            if (contact.normalX * contact.normalX + contact.normalY * contact.normalY > VERTICAL_NORMAL)
            {
                contact.setNormal(contact.normalX, contact.normalY, 0);
                contact.normalise();
                _rest.makeHorizontal();
            }
        }

        // Removes planes of this corner that are not needed, but not the newest. At the edges of tiles, a contact's plane may belong to a side that the
        // next tile hides. A plane is removed if the motion meets nothing in this corner without it. The rest of the motion has to be projected again
        // afterwards.
        private function dropNeedless(body:MovingBody, place:Vector3D, newest:int):void
        {
            for (var i:int = _rest.count - 1; i >= _rest.corner; i--)
            {
                if (i != newest)
                {
                    _rest.project(i);
                    if (_rest.length > 0 && !meetsInCorner(body, place))
                    {
                        _rest.remove(i);
                    }
                }
            }
        }

        // Whether the rest of the motion is stopped in this corner.
        private function meetsInCorner(body:MovingBody, place:Vector3D):Boolean
        {
            return _sweep.findFirst(body, place, _rest.motion, _tried) && isSameCorner(body, _tried) && !body.passes(_tried.row, _tried.contact);
        }

        // Whether what is met first is met in the same corner.
        private function isSameCorner(body:MovingBody, impact:Impact):Boolean
        {
            return impact.time * _rest.length < SAME_CORNER * body.core.slop;
        }
    }
}
