package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;

    /**
     * Moves a body as characters move: along what it meets, or straight on. The body ends a clearance before what stops it, so that the next motion
     * begins free.
     *
     * @private
     */
    public final class Slider
    {
        // If the next row is met within this many slops, this is the same corner.
        private static const SAME_CORNER:Number = 4;

        // A normal is vertical if the square of its horizontal part is at most this. The rest is a rounding error.
        private static const VERTICAL_NORMAL:Number = 1e-20;

        // A slide turns at this many contacts at most.
        private static const MOST_CONTACTS:int = 8;

        private var _sweep:CoreSweep = new CoreSweep();
        private var _recovery:OverlapRecovery = new OverlapRecovery();

        // The rest of the motion, what stops it first, and what stops it first without one of the planes.
        private var _rest:SlidePlanes = new SlidePlanes();
        private var _impact:Impact = new Impact();
        private var _tried:Impact = new Impact();

        // How the beginning lifts the body. The motion goes on from there.
        private var _lift:StartLift = new StartLift();

        /**
         * Computes a motion that slides along what it meets.
         *
         * @param rows the rows that may be in its way
         * @param from where it begins
         * @param motion the whole motion
         * @param limits how it may go
         * @param out receives the answer
         * @return the length of its way, as a part of the length of the motion, from 0 to 1
         */
        public function slide(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, limits:SlideLimits, out:SlideResult):Number
        {
            if (!begin(body, rows, from, motion, limits, out))
            {
                return 1;
            }
            var whole:Number = _rest.length;
            _rest.project();
            if (leaveOverlaps(body, from, out))
            {
                if (limits.staysLevel)
                {
                    standUpOverlaps();
                }
                _rest.project();
                findNext(body, out.place);
            }
            for (var contacts:int = 0; contacts < MOST_CONTACTS && _impact.row >= 0; contacts++)
            {
                goToTouch(body, out.place);
                noteFloor(out);
                if (_impact.contact.normalZ < limits.walkableZ)
                {
                    out.metWall = true;
                    standUp(_impact.contact);
                }
                else if (limits.walkableZ > 0)
                {
                    _rest.climb(_impact.contact);
                }
                dropNeedless(body, out.place, _rest.add(_impact.contact, _impact.row));
                _rest.project();
                findNext(body, out.place);
            }
            if (_impact.row < 0)
            {
                _rest.advance(out.place, 1);
            }
            return _rest.gone < whole ? _rest.gone / whole : 1;
        }

        /**
         * Computes a straight motion that ends where something stops it.
         *
         * @param rows the rows that may be in its way
         * @param from where it begins
         * @param motion the whole motion
         * @param out receives the answer. Its floor is what stops the motion
         * @return the free part of the motion, up to the touch, from 0 to 1
         */
        public function goStraight(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, out:SlideResult):Number
        {
            if (!begin(body, rows, from, motion, SlideLimits.NONE, out))
            {
                return 1;
            }
            if (leaveOverlaps(body, from, out))
            {
                out.floorRow = _rest.findCrossed(out.floor);
                if (out.floorRow >= 0)
                {
                    return 0;
                }
                findNext(body, out.place);
            }
            if (_impact.row < 0)
            {
                _rest.advance(out.place, 1);
                return 1;
            }
            out.floor.copyFrom(_impact.contact);
            out.floorRow = _impact.row;
            return goToTouch(body, out.place);
        }

        /** Whether a row would stop a body on a straight motion. What the body overlaps at the beginning stops it too. */
        public function meets(body:MovingBody, row:int, from:Vector3D, motion:Vector3D):Boolean
        {
            return body.beginMotion(body.rows, from, motion) && _sweep.findStop(body, row, from, motion, _tried);
        }

        /**
         * Leads a body a clearance off what it touches where its motions end, if there is room. What its last motion has passed, or has begun deep in,
         * does not count.
         *
         * @param place the place of the body, which changes
         */
        public function restoreClearance(body:MovingBody, place:Vector3D):void
        {
            _recovery.restoreClearance(body, place);
        }

        // Begins a motion that has met nothing yet. Returns whether it has a length. If not, this is its end.
        private function begin(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D, limits:SlideLimits, out:SlideResult):Boolean
        {
            out.place.copyFrom(from);
            out.isDeep = out.metWall = false;
            out.floor.setNormal(0, 0, -1);
            out.floorRow = -1;
            _rest.begin(motion, limits);
            if (body.beginMotion(rows, from, motion))
            {
                return true;
            }
            out.place.incrementBy(motion);
            return false;
        }

        // Frees the body from what it overlaps where the motion begins. If it overlaps nothing, finds what stops the motion first instead, because that
        // takes no longer than to know it. Returns whether the body may have overlapped something.
        private function leaveOverlaps(body:MovingBody, from:Vector3D, out:SlideResult):Boolean
        {
            if (_sweep.findFirstIfFree(body, from, _rest.motion, _impact))
            {
                return false;
            }
            _lift.clear();
            _recovery.leaveOverlaps(body, from, _rest, _lift);
            out.place.copyFrom(_lift.place);
            out.isDeep = _rest.count > 0;
            return true;
        }

        // Finds what stops the rest of the motion next.
        private function findNext(body:MovingBody, place:Vector3D):void
        {
            if (_rest.length > 0)
            {
                _sweep.findObstacle(body, place, _rest.motion, _impact);
            }
            else
            {
                _impact.row = -1;
            }
        }

        // Moves the body to the clearance before the touch of what its core has met. If that is not in the present corner, another corner begins.
        // Returns the time of the touch.
        private function goToTouch(body:MovingBody, place:Vector3D):Number
        {
            if (!isSameCorner(body, _impact))
            {
                _rest.beginCorner();
            }
            var touchTime:Number = _sweep.findTouchTime(body, place, _rest.motion, _impact);
            _rest.advance(place, Math.max(touchTime + body.core.clearance / _impact.along, 0));
            return touchTime;
        }

        // Keeps the most level surface that a slide has met.
        private function noteFloor(out:SlideResult):void
        {
            if (!_impact.isNormalFallback && (out.floorRow < 0 || _impact.contact.normalZ > out.floor.normalZ))
            {
                out.floor.copyFrom(_impact.contact);
                out.floorRow = _impact.row;
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

        // Turns the planes of what the body overlaps into upright walls, except of level floors and ceilings.
        private function standUpOverlaps():void
        {
            for (var i:int = 0; i < _rest.count; i++)
            {
                if (Math.abs(_rest.contacts[i].normalZ) < SlideLimits.LEVEL_Z)
                {
                    standUp(_rest.contacts[i]);
                }
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
