package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.NumberList;
    import starlogo.geometry.Tolerances;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;

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

        private var _body:MovingBody;
        private var _sweep:CoreSweep;
        private var _recovery:OverlapRecovery;

        // The rows that may be in the way.
        private var _rows:NumberList = null;

        // Where the motion begins.
        private var _from:Vector3D = new Vector3D();

        // Where the lifted body begins, and the lift.
        private var _liftedPlace:Vector3D = new Vector3D();
        private var _lift:StartLift = new StartLift();

        // What is left of the motion, and what is met first on that.
        private var _rest:SlidePlanes = new SlidePlanes();
        private var _impact:Impact = new Impact();

        // What is met first without one of the planes.
        private var _tried:Impact = new Impact();

        // The setup of a motion that is not made.
        private var _tryingSetup:MotionSetup = new MotionSetup();

        // The contact with a row that the core overlaps.
        private var _contact:ContactPoint = new ContactPoint();

        /** @param seen has the rows, and tests which of them touch */
        public function Mover(seen:SeenAgents)
        {
            _body = new MovingBody(seen);
            _sweep = new CoreSweep(seen, _body);
            _recovery = new OverlapRecovery(_body);
        }

        /**
         * Takes the body and the rows for the next motions.
         *
         * @param body the body that moves. It stays where it is
         * @param rows the rows that may be in its way. The list must not change before the next call
         */
        public function setBody(body:Body, rows:NumberList):void
        {
            _rows = rows;
            _body.setBody(body, rows);
        }

        /**
         * Computes how the beginning of a motion lifts the body out of its rows, all together.
         *
         * @param setup receives the setup of the motion
         * @param out receives the lift: 0 if the body overlaps nothing, or does not get free
         * @return whether there is a lift
         */
        public function findLift(from:Vector3D, motion:Vector3D, setup:MotionSetup, out:StartLift):Boolean
        {
            beginMotion(from, motion, null, SlideLimits.NONE, setup, _liftedPlace);
            out.copyFrom(_lift);
            return out.isLifted;
        }

        /**
         * Computes a motion that ends when it first touches a row.
         *
         * @param from where it begins
         * @param motion the whole motion
         * @param lift the lift of <code>findLift()</code>; null for none
         * @param setup receives the setup of the motion
         * @param out receives the answer. Rounding may hide the touch at its place: see <code>goIntoTouch()</code>
         */
        public function findTouch(from:Vector3D, motion:Vector3D, lift:StartLift, setup:MotionSetup, out:MotionResult):void
        {
            var isMotion:Boolean = beginMotion(from, motion, lift, SlideLimits.NONE, setup, _liftedPlace);
            var crossed:int = isMotion ? _rest.findCrossed() : -1;
            out.row = -1;
            out.fraction = 1;
            out.contact.setNormal(0, 0, 0);
            out.isDeep = _rest.count > 0;
            out.isLifted = _lift.isLifted;
            if (crossed >= 0)
            {
                out.contact.copyFrom(_rest.planes[crossed]);
                out.row = _rest.rows[crossed];
                out.fraction = 0;
            }
            else if (isMotion && findObstacle(setup.obstacles, _liftedPlace, _impact))
            {
                takeImpact(motion, out);
            }
            goAlong(motion, out.fraction, out.place);
        }

        /**
         * Moves the end of a motion into the touch, on the side that it comes from. If it went beyond a row without thickness, the two would not
         * touch, and it could not come back. It tries several places. The first is half a tolerance before the contact. The tolerance is the
         * distance across which the two still touch. On a long way rounding may hide the touch. Then the body ends where its core touches the row.
         *
         * @param setup the setup of the motion
         * @param result the answer of <code>findTouch()</code>, whose place changes
         */
        public function goIntoTouch(setup:MotionSetup, result:MotionResult):void
        {
            if (result.row < 0 || result.fraction == 0)
            {
                return;
            }
            _body.resume(setup);
            var half:Number = _body.halfToleranceAt(result.row, result.place);
            result.contact.push(result.place, half);
            for (var i:int = 0; i < STEPS_INTO_TOUCH; i++)
            {
                if (_body.touches(result.row, result.place))
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
         * @param from where it begins
         * @param motion the whole motion
         * @param setup receives the setup of the motion
         * @param out receives the answer of <code>findTouch()</code> without a lift, but its place is the clearance before the touch. Its fraction
         *     is that of the touch
         */
        public function goBeforeTouch(from:Vector3D, motion:Vector3D, setup:MotionSetup, out:MotionResult):void
        {
            findTouch(from, motion, null, setup, out);
            if (out.row >= 0 && out.fraction > 0)
            {
                goAlong(motion, Math.max(0, out.fraction + setup.clearance / out.along), out.place);
            }
        }

        /**
         * Computes a motion that slides along what it meets.
         *
         * @param from where it begins
         * @param motion the whole motion
         * @param limits how it may go
         * @param setup receives the setup of the motion
         * @param out receives the answer
         */
        public function slide(from:Vector3D, motion:Vector3D, limits:SlideLimits, setup:MotionSetup, out:SlideResult):void
        {
            var place:Vector3D = out.place;
            out.fraction = 1;
            out.metWall = false;
            out.floor.setNormal(0, 0, -1);
            out.floorRow = out.clearRow = -1;
            if (!beginMotion(from, motion, null, limits, setup, place))
            {
                place.incrementBy(motion);
                return;
            }
            var whole:Number = _rest.length;
            _rest.project();
            for (var iterations:int = 0; iterations < MOST_ITERATIONS && _rest.length > 0; iterations++)
            {
                var isMet:Boolean = findObstacle(setup.obstacles, place, _impact);
                out.clearRow = _impact.clearRow;
                if (!isMet)
                {
                    _rest.advance(place, 1);
                    break;
                }
                if (!isSameCorner(_impact))
                {
                    _rest.beginCorner();
                }
                _sweep.findTouchTime(place, _rest.motion, _impact);
                _rest.advance(place, Math.max(_impact.touchTime + setup.clearance / _impact.along, 0));
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
                dropNeedless(setup.obstacles, place);
                _rest.project();
            }
            out.fraction = _rest.gone < whole ? _rest.gone / whole : 1;
        }

        /** Whether the body would go into a row on a straight way from a place. */
        public function meets(row:int, from:Vector3D, motion:Vector3D):Boolean
        {
            _body.beginMotion(from, motion, _tryingSetup);
            return _sweep.meets(row, from, motion);
        }

        /**
         * Finds the contact of the deepest overlap of the body at a place.
         *
         * @param setup of a motion before, perhaps among other rows
         * @param out receives the contact
         * @return the sum of the depths of all overlaps
         */
        public function findDeepest(place:Vector3D, setup:MotionSetup, out:ContactPoint):Number
        {
            _body.resume(setup);
            return _recovery.findDeepest(_rows, place, out);
        }

        /**
         * Lifts the body off what it only touches, if there is room.
         *
         * @param setup of the motion that ends here
         * @param place the place of the body, which changes
         * @param clearRow a row that it is known not to touch there, or -1
         */
        public function restoreClearance(place:Vector3D, setup:MotionSetup, clearRow:int):void
        {
            _body.resume(setup);
            _recovery.restoreClearance(setup.obstacles, place, clearRow);
        }

        // Begins a motion. The place receives where the body begins: lifted out of what it overlaps. Returns whether there is any motion.
        private function beginMotion(from:Vector3D, motion:Vector3D, lift:StartLift, limits:SlideLimits, setup:MotionSetup, place:Vector3D):Boolean
        {
            _from.copyFrom(from);
            place.copyFrom(from);
            _rest.begin(motion, limits);
            _lift.clear();
            setup.obstacles.copyFrom(_rows);
            _body.beginMotion(from, motion, setup);
            if (!(_rest.length * _rest.length > Tolerances.VANISHING))
            {
                return false;
            }
            if (lift != null)
            {
                _lift.copyFrom(lift);
                place.incrementBy(lift.displacement);
            }
            _lift.mostDepth = SLOPS_TO_LEAVE * setup.slop;
            if (replaceDeep(setup.obstacles, place, false) && !_recovery.liftOut(setup.obstacles, place, _lift))
            {
                place.copyFrom(_from);
                _lift.clear();
                replaceDeep(setup.obstacles, place, true);
            }
            if (setup.isFlat && _rest.count == 0)
            {
                // its core is as flat, and a sweep touches across a wider gap than a body that stands
                _recovery.restoreClearance(setup.obstacles, place, -1);
            }
            _lift.displacement.copyFrom(place);
            _lift.displacement.decrementBy(_from);
            _rest.beginCorner();
            return true;
        }

        // Lets planes take the places of rows that the core overlaps: of those whose overlap is not shallow, or of all. If the core does not
        // touch a row when it is narrower, the row stays, and the motion has that core. One-way rows that the body is within do not count any
        // more. Returns whether rows are left that the core overlapped.
        private function replaceDeep(obstacles:NumberList, place:Vector3D, isOfAll:Boolean):Boolean
        {
            var isLeft:Boolean = false;
            var kept:int = 0;
            for (var i:int = 0; i < obstacles.count; i++)
            {
                var row:int = obstacles.numbers[i];
                var touches:Boolean = _body.coreTouches(row, place);
                if (touches && _body.isWithinOneWay(row, place))
                {
                    continue;
                }
                if (touches && narrowOrFindDeep(row, place, isOfAll, _contact))
                {
                    _rest.add(_contact, row);
                    _body.warnIfInside(row, _contact);
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
        private function narrowOrFindDeep(row:int, place:Vector3D, isOfAll:Boolean, out:ContactPoint):Boolean
        {
            var isShallow:Boolean = _body.findContact(row, place, isOfAll, out);
            if (isShallow && !isOfAll)
            {
                return false;
            }
            var isFree:Boolean = _body.narrow(row, place);
            return !isFree && _body.overlaps(row, place);
        }

        // Finds the touch of the motion whose core meets the impact.
        private function takeImpact(motion:Vector3D, out:MotionResult):void
        {
            _sweep.findTouchTime(_liftedPlace, motion, _impact);
            out.row = _impact.row;
            out.contact.copyFrom(_impact.contact);
            out.contact.depth = 0;
            out.corePlace.setTo(_liftedPlace.x + _impact.time * motion.x, _liftedPlace.y + _impact.time * motion.y, _liftedPlace.z + _impact.time * motion.z);
            out.along = _impact.along;
            // without the lift the body would have touched earlier
            var time:Number = _impact.touchTime + out.contact.along(_lift.displacement) / out.along;
            out.fraction = time > 0 ? (time < 1 ? time : 1) : 0;
            if (-out.fraction * out.along < _body.setup.slop && _body.touches(out.row, _from))
            {
                out.fraction = 0;
            }
        }

        // Finds the place at a part of the motion from its beginning before the lift, but no deeper in what it was lifted out of.
        private function goAlong(motion:Vector3D, part:Number, out:Vector3D):void
        {
            out.setTo(_from.x + part * motion.x, _from.y + part * motion.y, _from.z + part * motion.z);
            _lift.keepDepth(out, _from);
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
        private function dropNeedless(obstacles:NumberList, place:Vector3D):void
        {
            for (var i:int = _rest.count - 2; i >= _rest.corner; i--)
            {
                _rest.project(i);
                if (_rest.length > 0 && !(_sweep.findFirst(obstacles, place, _rest.motion, _tried) && isSameCorner(_tried)))
                {
                    _rest.remove(i);
                }
            }
        }

        // Whether what is met first is met in the same corner.
        private function isSameCorner(impact:Impact):Boolean
        {
            return impact.time * _rest.length < SAME_CORNER * _body.setup.slop;
        }

        // Finds what the rest of the motion meets first. One-way rows that it passes do not count from then on.
        private function findObstacle(obstacles:NumberList, place:Vector3D, out:Impact):Boolean
        {
            while (_sweep.findFirst(obstacles, place, _rest.motion, out))
            {
                if (!_body.passes(out.row, out.contact))
                {
                    return true;
                }
                obstacles.remove(out.row);
            }
            return false;
        }
    }
}
