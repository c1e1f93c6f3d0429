package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.NumberList;
    import starlogo.geometry.Tolerances;
    import starlogo.queries.SeenAgents;

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
        private static const SAME_CORNER:Number = 4;

        // If a motion leads this many slops deeper into what it was lifted out of, the body has left the surface. Otherwise its core would meet it.
        private static const SLOPS_TO_LEAVE:Number = 2;

        // A normal is vertical if the square of its horizontal part is at most this. The rest is a rounding error.
        private static const VERTICAL_NORMAL:Number = 1e-20;

        // A slide ends after this many iterations.
        private static const MOST_ITERATIONS:int = 8;

        private var _sweep:CoreSweep;
        private var _recovery:OverlapRecovery = new OverlapRecovery();

        // How the beginning of a straight motion lifts the body, and where the lifted body begins.
        private var _lift:StartLift = new StartLift();
        private var _liftedPlace:Vector3D = new Vector3D();

        // What is left of the motion, what is met first on that, and what is met first without one of the planes.
        private var _rest:SlidePlanes = new SlidePlanes();
        private var _impact:Impact = new Impact();
        private var _tried:Impact = new Impact();

        // The contact with a row that the core overlaps.
        private var _contact:ContactPoint = new ContactPoint();

        /** @param seen has the rows, and tests which of them touch */
        public function Mover(seen:SeenAgents)
        {
            _sweep = new CoreSweep(seen);
        }

        /**
         * Computes how the beginning of a motion lifts a body out of rows, all together.
         *
         * @param rows the rows
         * @param out receives the lift: 0 if the body overlaps nothing, or does not get free
         * @return whether there is a lift
         */
        public function findLift(body:MovingBody, rows:NumberList, from:Vector3D, motion:Vector3D, out:StartLift):Boolean
        {
            out.clear();
            begin(body, rows, from, motion, SlideLimits.NONE, out, _liftedPlace);
            return out.isLifted;
        }

        /**
         * Computes a motion that ends when it first touches a row.
         *
         * @param rows the rows that may be in its way
         * @param from where it begins: not <code>out.place</code>, which is written before the end
         * @param motion the whole motion
         * @param lift the lift of <code>findLift()</code> with which it begins, or <code>StartLift.NONE</code>
         * @param out receives the answer. Rounding may hide the touch at its place: see <code>goIntoTouch()</code>
         */
        public function findTouch(body:MovingBody, rows:NumberList, from:Vector3D, motion:Vector3D, lift:StartLift, out:MotionResult):void
        {
            _lift.copyFrom(lift);
            var isMotion:Boolean = begin(body, rows, from, motion, SlideLimits.NONE, _lift, _liftedPlace);
            var crossed:int = isMotion ? _rest.findCrossed() : -1;
            out.row = -1;
            out.fraction = 1;
            out.contact.setNormal(0, 0, 0);
            out.isDeep = _rest.count > 0;
            out.isLifted = _lift.isLifted;
            if (crossed >= 0)
            {
                out.contact.copyFrom(_rest.planes[crossed]);
                // the plane stands for all triangles of the row
                out.contact.triangle = -1;
                out.row = _rest.rows[crossed];
                out.fraction = 0;
            }
            else if (isMotion && findObstacle(body, _liftedPlace, _impact))
            {
                takeImpact(body, from, motion, out);
            }
            goAlong(from, motion, out.fraction, out.place);
        }

        /**
         * Moves the end of a motion into the touch, on the side that it comes from. If it went beyond a row without thickness, the two would not
         * touch, and it could not come back. It tries several places. The first is half a tolerance before the contact. The tolerance is the
         * distance across which the two still touch. On a long way rounding may hide the touch. Then the body ends where its core touches the row.
         *
         * @param result the answer of <code>findTouch()</code> for this body, whose place changes
         */
        public function goIntoTouch(body:MovingBody, result:MotionResult):void
        {
            if (result.row < 0 || result.fraction == 0)
            {
                return;
            }
            var half:Number = body.halfToleranceAt(result.row, result.place);
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
        public function goBeforeTouch(body:MovingBody, rows:NumberList, from:Vector3D, motion:Vector3D, out:MotionResult):void
        {
            findTouch(body, rows, from, motion, StartLift.NONE, out);
            if (out.row >= 0 && out.fraction > 0)
            {
                goAlong(from, motion, Math.max(0, out.fraction + body.clearance / _impact.along), out.place);
            }
        }

        /**
         * Computes a motion that slides along what it meets.
         *
         * @param rows the rows that may be in its way
         * @param from where it begins
         * @param motion the whole motion
         * @param limits how it may go
         * @param out receives the answer
         */
        public function slide(body:MovingBody, rows:NumberList, from:Vector3D, motion:Vector3D, limits:SlideLimits, out:SlideResult):void
        {
            var place:Vector3D = out.place;
            out.fraction = 1;
            out.metWall = false;
            out.floor.setNormal(0, 0, -1);
            out.floorRow = -1;
            _lift.clear();
            if (!begin(body, rows, from, motion, limits, _lift, place))
            {
                place.incrementBy(motion);
                return;
            }
            var whole:Number = _rest.length;
            _rest.project();
            for (var iterations:int = 0; iterations < MOST_ITERATIONS && _rest.length > 0; iterations++)
            {
                if (!findObstacle(body, place, _impact))
                {
                    _rest.advance(place, 1);
                    break;
                }
                if (!isSameCorner(body, _impact))
                {
                    _rest.beginCorner();
                }
                _rest.advance(place, Math.max(_impact.touchTime + body.clearance / _impact.along, 0));
                if (!_impact.isNormalFallback && (out.floorRow < 0 || _impact.contact.normalZ > out.floor.normalZ))
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
                dropNeedless(body, place);
                _rest.project();
            }
            out.fraction = _rest.gone < whole ? _rest.gone / whole : 1;
        }

        /** Whether a body would go into a row on a straight motion. */
        public function meets(body:MovingBody, row:int, from:Vector3D, motion:Vector3D):Boolean
        {
            body.beginMotion(body.rows, from, motion);
            return _sweep.meets(body, row, from, motion);
        }

        // Begins a motion, displaced by a lift. The lift receives what else the body is lifted out of; the last argument, where it then is. Returns
        // whether there is any motion.
        private function begin(body:MovingBody, rows:NumberList, from:Vector3D, motion:Vector3D, limits:SlideLimits, lift:StartLift, place:Vector3D):Boolean
        {
            place.copyFrom(from);
            _rest.begin(motion, limits);
            body.beginMotion(rows, from, motion);
            if (!(_rest.length * _rest.length > Tolerances.VANISHING))
            {
                lift.clear();
                return false;
            }
            place.incrementBy(lift.displacement);
            lift.mostDepth = SLOPS_TO_LEAVE * body.slop;
            if (replaceDeep(body, place, false) && !_recovery.liftOut(body, place, lift))
            {
                place.copyFrom(from);
                lift.clear();
                replaceDeep(body, place, true);
            }
            if (body.isFlat && _rest.count == 0)
            {
                // its core is as flat, and a sweep touches across a wider gap than a body that stands
                _recovery.restoreClearance(body, place);
            }
            lift.displacement.copyFrom(place);
            lift.displacement.decrementBy(from);
            _rest.beginCorner();
            return true;
        }

        // Lets planes take the places of rows that the core overlaps: of those whose overlap is not shallow, or of all. If the core does not
        // touch a row when it is narrower, the row stays, and the motion has that core. One-way rows that the body is within do not count any
        // more. Returns whether rows are left that the core overlapped.
        private function replaceDeep(body:MovingBody, place:Vector3D, isOfAll:Boolean):Boolean
        {
            var obstacles:NumberList = body.obstacles;
            var isLeft:Boolean = false;
            var kept:int = 0;
            for (var i:int = 0; i < obstacles.count; i++)
            {
                var row:int = obstacles.numbers[i];
                var touches:Boolean = body.coreTouches(row, place);
                if (touches && body.isWithinOneWay(row, place))
                {
                    continue;
                }
                if (touches && narrowOrFindDeep(body, row, place, isOfAll, _contact))
                {
                    _rest.add(_contact, row);
                    body.warnIfInside(row, _contact);
                }
                else
                {
                    isLeft ||= touches;
                    obstacles.numbers[kept] = row;
                    kept++;
                }
            }
            obstacles.count = kept;
            return isLeft;
        }

        // Narrows the core for this motion, so that it does not touch a row, or finds their contact. Returns whether the contact's plane has to
        // take the place of the row: if the overlap is not shallow, or all count, and no narrower core is free of the row.
        private function narrowOrFindDeep(body:MovingBody, row:int, place:Vector3D, isOfAll:Boolean, out:ContactPoint):Boolean
        {
            var isShallow:Boolean = body.findContact(row, place, isOfAll, out);
            if (isShallow && !isOfAll)
            {
                return false;
            }
            var isFree:Boolean = body.narrow(row, place);
            return !isFree && body.overlaps(row, place);
        }

        // Finds the touch of the lifted motion whose core has met the impact.
        private function takeImpact(body:MovingBody, from:Vector3D, motion:Vector3D, out:MotionResult):void
        {
            var impact:Impact = _impact;
            out.row = impact.row;
            out.contact.copyFrom(impact.contact);
            out.contact.depth = 0;
            out.corePlace.setTo(_liftedPlace.x + impact.time * motion.x, _liftedPlace.y + impact.time * motion.y, _liftedPlace.z + impact.time * motion.z);
            // without the lift the body would have touched earlier
            var time:Number = impact.touchTime + out.contact.along(_lift.displacement) / impact.along;
            out.fraction = time > 0 ? (time < 1 ? time : 1) : 0;
            if (-out.fraction * impact.along < body.slop && body.touches(out.row, from))
            {
                out.fraction = 0;
            }
        }

        // Finds the place at a part of the motion from its beginning before the lift, but no deeper in what it was lifted out of.
        private function goAlong(from:Vector3D, motion:Vector3D, part:Number, out:Vector3D):void
        {
            out.setTo(from.x + part * motion.x, from.y + part * motion.y, from.z + part * motion.z);
            _lift.keepDepth(out, from);
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

        // Removes planes that are not needed. At the edges of tiles, a contact's plane may belong to a side that the next tile hides. A plane is
        // removed if the motion meets nothing in this corner without it. The rest of the motion has to be projected again afterwards.
        private function dropNeedless(body:MovingBody, place:Vector3D):void
        {
            for (var i:int = _rest.count - 2; i >= _rest.corner; i--)
            {
                _rest.project(i);
                if (_rest.length > 0 && !(_sweep.findFirst(body, place, _rest.motion, _tried) && isSameCorner(body, _tried)))
                {
                    _rest.remove(i);
                }
            }
        }

        // Whether what is met first is met in the same corner.
        private function isSameCorner(body:MovingBody, impact:Impact):Boolean
        {
            return impact.time * _rest.length < SAME_CORNER * body.slop;
        }

        // Finds what the rest of the motion meets first. One-way rows that it passes do not count from then on.
        private function findObstacle(body:MovingBody, place:Vector3D, out:Impact):Boolean
        {
            while (_sweep.findFirst(body, place, _rest.motion, out))
            {
                if (!body.passes(out.row, out.contact))
                {
                    return true;
                }
                body.obstacles.remove(out.row);
            }
            return false;
        }
    }
}
