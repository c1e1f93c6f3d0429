package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.geometry.Tolerances;
    import starlogo.search.Body;
    import starlogo.search.NumberList;

    /**
     * Moves a body among rows of a table, until it touches one of them, or along the rows that it touches. A row that it would go into stops
     * it. A row that it only touches, leaves or runs along never stops it, because the core of the body is swept (CoreSweep).
     *
     * <p>At the beginning the body may overlap rows a little, because of rounding in the game. Then it is lifted out of them first
     * (OverlapRecovery). If it overlaps a row more deeply, the plane of their contact stands for that row. The motion must not cross the plane, and
     * nothing else of that row counts.</p>
     *
     * @private
     */
    public final class Mover
    {
        // The number of places that are tried in order to find one at which the two touch. A sweep may end some 30 gaps before a triangle of
        // the ground.
        private static const STEPS_INTO_TOUCH:int = 64;

        // If the next row is met within this many slops, this is the same corner.
        private static const NEXT:Number = 4;

        // If a motion leads this many slops deeper into what it was lifted out of, the body has left the surface. Otherwise its core would meet it.
        private static const MOST_SLOPS:Number = 2;

        // A normal is vertical if the square of its horizontal part is at most this. The rest is a rounding error.
        private static const UPRIGHT:Number = 1e-20;

        // A slide ends after this many iterations.
        private static const MOST_ITERATIONS:int = 8;

        private var _body:MovingBody;
        private var _sweep:CoreSweep;
        private var _recovery:OverlapRecovery;

        // The rows that may be in the way, and those of them that no plane replaces.
        private var _rows:NumberList = new NumberList();
        private var _obstacles:NumberList = new NumberList();

        // The motion: where it begins, what is left of it, how the body is lifted, and what is met first on the rest and on another way.
        private var _from:Vector3D = new Vector3D();
        private var _rest:SlidePlanes = new SlidePlanes();
        private var _lift:StartLift = new StartLift();
        private var _impact:Impact = new Impact();
        private var _tried:Impact = new Impact();
        private var _contact:ContactPoint = new ContactPoint();

        // Where the core touches what the last motion touches.
        private var _corePlace:Vector3D = new Vector3D();

        /** @param seen has the rows, and tests which of them touch */
        public function Mover(seen:QueryWorld)
        {
            _body = new MovingBody(seen);
            _sweep = new CoreSweep(seen, _body);
            _recovery = new OverlapRecovery(_body);
        }

        /**
         * Takes the body and the rows for the next motions.
         *
         * @param body the body that moves. It stays where it is
         * @param rows the rows that may be in its way
         * @param except a row that does not count, or -1
         */
        public function begin(body:Body, rows:NumberList, except:int = -1):void
        {
            _rows.count = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                if (rows.numbers[i] != except)
                {
                    _rows.add(rows.numbers[i]);
                }
            }
            _body.read(body, _rows);
        }

        /** Takes the body and a single row for the next motions. */
        public function beginAgainst(body:Body, row:int):void
        {
            _rows.count = 0;
            _rows.add(row);
            _body.read(body, _rows);
        }

        /**
         * Computes how the beginning of a motion lifts the body out of its rows, all together.
         *
         * @param out receives the lift: 0 if the body overlaps nothing, or does not get free
         * @return whether there is a lift
         */
        public function findLift(from:Vector3D, motion:Vector3D, end:Motion, out:StartLift):Boolean
        {
            start(from, motion, null, SlideLimits.NONE, end);
            out.copyFrom(_lift);
            out.way.copyFrom(end.place);
            out.way.decrementBy(_from);
            return end.isLifted;
        }

        /**
         * Finds when a motion first touches a row, and how.
         *
         * @param from where it begins
         * @param motion the whole motion
         * @param lift the lift of <code>findLift()</code>; null for none
         * @param out receives the answer. Its place is the end if no row is touched, else the beginning; then <code>goIntoTouch()</code> gives
         *     the end
         */
        public function findTouch(from:Vector3D, motion:Vector3D, lift:StartLift, out:Motion):void
        {
            if (!start(from, motion, lift, SlideLimits.NONE, out))
            {
                return;
            }
            var crossed:int = _rest.findCrossed();
            if (crossed >= 0)
            {
                out.contact.copyFrom(_rest.planes[crossed]);
                out.row = _rest.rows[crossed];
                out.fraction = 0;
            }
            else if (findFirst(out.place, _impact))
            {
                _sweep.findTouch(out.place, motion, _impact);
                out.row = _impact.row;
                out.contact.copyFrom(_impact.contact);
                out.contact.depth = 0;
                _corePlace.setTo(out.place.x + _impact.time * motion.x, out.place.y + _impact.time * motion.y, out.place.z + _impact.time * motion.z);
                // without the lift the body would have touched earlier
                out.place.decrementBy(_from);
                var time:Number = _impact.touchTime + out.contact.along(out.place) / _impact.along;
                out.fraction = time > 0 ? (time < 1 ? time : 1) : 0;
                if (-out.fraction * _impact.along < _body.slop && _body.touches(out.row, _from))
                {
                    out.fraction = 0;
                }
            }
            out.place.copyFrom(_from);
            if (out.row < 0)
            {
                advance(1, out.place);
            }
        }

        /**
         * Moves the body of the last motion into the touch, on the side that it comes from. If it went beyond a row without thickness, the two
         * would not touch, and it could not come back. On a long way rounding may hide the touch. Then the body ends where its core touches the row.
         *
         * @param motion the answer of <code>findTouch()</code>, whose place changes
         */
        public function goIntoTouch(motion:Motion):void
        {
            if (motion.row >= 0 && motion.fraction > 0)
            {
                advance(motion.fraction, motion.place);
                if (!stepIntoTouch(motion))
                {
                    motion.place.copyFrom(_corePlace);
                }
            }
        }

        /**
         * Computes where a motion ends that goes until the clearance before a touch.
         *
         * @param from where it begins
         * @param motion the whole motion
         * @param out receives the answer
         */
        public function goBeforeTouch(from:Vector3D, motion:Vector3D, out:Motion):void
        {
            findTouch(from, motion, null, out);
            if (out.row >= 0 && out.fraction > 0)
            {
                advance(Math.max(0, out.fraction + _body.clearance / _impact.along), out.place);
            }
        }

        /**
         * Computes where a motion ends that slides along what it meets.
         *
         * @param from where it begins
         * @param motion the whole motion
         * @param limits how it may go
         * @param out receives the answer
         */
        public function slide(from:Vector3D, motion:Vector3D, limits:SlideLimits, out:Motion):void
        {
            if (!start(from, motion, null, limits, out))
            {
                return;
            }
            var whole:Number = _rest.length;
            for (var iterations:int = 0; iterations < MOST_ITERATIONS && _rest.project(); iterations++)
            {
                if (!findFirst(out.place, _impact))
                {
                    _rest.advance(out.place, 1);
                    break;
                }
                if (!isSoon(_impact))
                {
                    _rest.beginCorner();
                }
                _sweep.findTouch(out.place, _rest.motion, _impact);
                _rest.advance(out.place, Math.max(_impact.touchTime + _body.clearance / _impact.along, 0));
                if (!_impact.isNormalFallback && _impact.contact.normalZ > out.floor.normalZ)
                {
                    out.floor.copyFrom(_impact.contact);
                    out.floorRow = _impact.row;
                }
                if (_impact.contact.normalZ < limits.walkableZ)
                {
                    out.metWall = true;
                    standUp(_impact.contact);
                }
                _rest.add(_impact.contact, _impact.row);
                dropNeedless(out.place);
            }
            out.clearRow = _impact.clearRow;
            out.fraction = _rest.gone < whole ? _rest.gone / whole : 1;
        }

        /** Whether the body would go into a row on a straight way from a place. */
        public function meets(row:int, from:Vector3D, motion:Vector3D):Boolean
        {
            _body.setMotion(from, motion);
            return _sweep.meets(row, from, motion);
        }

        /** Finds the contact of the deepest overlap of the body at a place. Returns the sum of the depths of all overlaps. */
        public function findDeepest(place:Vector3D, out:ContactPoint):Number
        {
            return _recovery.findDeepest(_rows, place, out);
        }

        /**
         * After a motion: lifts the body off what it only touches, if there is room.
         *
         * @param place the place of the body, which changes
         * @param clearRow a row that it is known not to touch there, or -1
         */
        public function restoreClearance(place:Vector3D, clearRow:int):void
        {
            _recovery.restoreClearance(_obstacles, place, clearRow);
        }

        // Begins a motion at a place that is lifted out of what the body overlaps there. Returns whether there is any motion.
        private function start(from:Vector3D, motion:Vector3D, lift:StartLift, limits:SlideLimits, out:Motion):Boolean
        {
            out.beginAt(from);
            _from.copyFrom(from);
            _impact.clearRow = -1;
            _rest.begin(motion, limits);
            _lift.clear();
            _obstacles.copyFrom(_rows);
            _body.setMotion(from, motion);
            if (!(_rest.length * _rest.length > Tolerances.VANISHING))
            {
                _rest.advance(out.place, 1);
                return false;
            }
            if (lift != null)
            {
                _lift.copyFrom(lift);
                out.place.incrementBy(lift.way);
            }
            _lift.most = MOST_SLOPS * _body.slop;
            var lifted:int = _lift.count;
            if (takeDeep(out.place, false) && !_recovery.liftOut(_obstacles, out.place, _lift))
            {
                out.place.copyFrom(_from);
                _lift.clear();
                takeDeep(out.place, true);
            }
            out.isLifted = _lift.count > lifted;
            out.isDeep = _rest.count > 0;
            if (_body.isFlat && !out.isDeep)
            {
                // its core is as flat, and a sweep touches across a wider gap than a body that stands
                out.isLifted = _recovery.restoreClearance(_obstacles, out.place, -1) || out.isLifted;
            }
            _rest.beginCorner();
            return true;
        }

        // Lets planes take the places of rows that the core overlaps: of those whose overlap is not shallow, or of all. If the core does not
        // touch a row when it is narrower, the row stays, and the motion has that core. One-way rows that the body is within do not count any
        // more. Returns whether rows are left that the core overlapped.
        private function takeDeep(place:Vector3D, isOfAll:Boolean):Boolean
        {
            var isLeft:Boolean = false;
            var kept:int = 0;
            for (var i:int = 0; i < _obstacles.count; i++)
            {
                var row:int = _obstacles.numbers[i];
                var touches:Boolean = _body.coreTouches(row, place);
                if (touches && _body.isWithinOneWay(row, place))
                {
                    continue;
                }
                if (touches && findDeep(row, place, isOfAll, _contact))
                {
                    _rest.add(_contact, row);
                }
                else
                {
                    isLeft ||= touches;
                    _obstacles.numbers[kept] = row;
                    kept++;
                }
            }
            _obstacles.count = kept;
            return isLeft;
        }

        // Finds the contact with a row that the core overlaps. Returns whether its plane has to take the place of the row.
        private function findDeep(row:int, place:Vector3D, isOfAll:Boolean, out:ContactPoint):Boolean
        {
            var isShallow:Boolean = _body.findContact(row, place, isOfAll, out);
            return (isOfAll || !isShallow) && !_body.narrow(row, place) && _body.overlaps(row, place);
        }

        // Moves a place by a part of the motion from its beginning before the lift, but no deeper into what it was lifted out of.
        private function advance(part:Number, place:Vector3D):void
        {
            place.copyFrom(_from);
            _rest.advance(place, part);
            _lift.keepDepth(place, _from.x, _from.y, _from.z);
        }

        // Tries several places, from half a margin before the contact on. The margin is the gap across which the two still touch. Returns whether
        // they touch at one of the places.
        private function stepIntoTouch(out:Motion):Boolean
        {
            var half:Number = _body.halfToleranceAt(out.row, out.place);
            out.contact.push(out.place, half);
            for (var i:int = 1; i < STEPS_INTO_TOUCH; i++)
            {
                if (_body.touches(out.row, out.place))
                {
                    return true;
                }
                out.contact.push(out.place, -half);
            }
            return _body.touches(out.row, out.place);
        }

        // Turns a contact that is too steep into an upright wall. The rest of the motion becomes level, because the slope would stop a motion up
        // or down.
        private function standUp(contact:ContactPoint):void
        {
            if (contact.normalX * contact.normalX + contact.normalY * contact.normalY > UPRIGHT)
            {
                contact.setNormal(contact.normalX, contact.normalY, 0);
                contact.normalise();
                _rest.makeHorizontal();
            }
        }

        // Removes planes that are not needed. At the edges of tiles, a contact's plane may belong to a side that the next tile hides. A plane is
        // removed if the motion meets nothing in this corner without it.
        private function dropNeedless(place:Vector3D):void
        {
            for (var i:int = _rest.count - 2; i >= _rest.corner; i--)
            {
                if (_rest.project(i) && !(_sweep.findFirst(_obstacles, place, _rest.motion, _tried) && isSoon(_tried)))
                {
                    _rest.remove(i);
                }
            }
        }

        // Whether what is met first is met in the same corner.
        private function isSoon(impact:Impact):Boolean
        {
            return impact.time * _rest.length < NEXT * _body.slop;
        }

        // Finds what the rest of the motion meets first. One-way rows that it passes do not count from then on.
        private function findFirst(place:Vector3D, out:Impact):Boolean
        {
            while (_sweep.findFirst(_obstacles, place, _rest.motion, out))
            {
                if (!_body.passes(out.row, out.contact))
                {
                    return true;
                }
                _obstacles.remove(out.row);
            }
            return false;
        }
    }
}
