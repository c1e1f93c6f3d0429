package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;

    /**
     * Frees the core of a body from what it overlaps where a motion begins (leaveOverlaps), and leads the body off what it touches where its motions end
     * (restoreClearance).
     *
     * <p>A shallow overlap comes from rounding in the game: the body is lifted out of it. If the body overlaps a row more deeply, the plane of their
     * contact stands for that row. The motion must not cross the plane, and nothing else of the row counts.</p>
     *
     * <p>The body is pushed out of one row after the other, in rounds, because a push out of one side of a hollow leads a part of the way into
     * another. If it does not get free, for example between two opposite walls, it stays where it was. The tests of a pair know the shortest way
     * out of that pair (PairTests.separate).</p>
     *
     * @private
     */
    public final class OverlapRecovery
    {
        private static const ROUNDS:int = 30;

        // From this round on contacts have to separate. Contacts of parts of a body may point sideways, round after round.
        private static const SURE_ROUND:int = 2;

        // If a body only touches a row, it is never this many slops deep in it.
        private static const SLOPS_OF_TOUCH:Number = 2;

        // Two normals are opposite if the cosine of the angle between them is less than this.
        private static const OPPOSITE:Number = -0.999;

        // The core of a body that stands, with its tolerances.
        private var _core:BodyCore = new BodyCore();

        // Where the pushes begin.
        private var _before:Vector3D = new Vector3D();

        // The contact of this push and of the last one.
        private var _contact:ContactPoint = new ContactPoint();
        private var _last:ContactPoint = new ContactPoint();

        // A place where the body touches a row, and the way from there to the place of the body.
        private var _touching:Vector3D = new Vector3D();
        private var _beside:Vector3D = new Vector3D();

        /**
         * Frees the core of a body from the obstacles that it overlaps where its motion starts.
         *
         * @param start how the motion starts. It receives the planes of deep overlaps. Obstacles for which a plane stands are none from then on. The
         *     place changes if the body is lifted
         */
        public function leaveOverlaps(start:MotionStart):void
        {
            if (replaceObstacles(start, false) && !lift(start))
            {
                replaceObstacles(start, true);
            }
            if (start.core.isFlat && start.planes.count == 0)
            {
                // its core is as flat, and a sweep touches across a wider gap than a body that stands
                pushOff(start.core, start.obstacles, start.place);
            }
        }

        /**
         * Leads a body that stands a clearance off the rows that it touches, if there is room. A flat body is led also off those that it is close to. Rows
         * that it overlaps deeply do not count, nor one-way rows that it passes.
         *
         * @param place the place of the body, which changes
         */
        public function restoreClearance(body:MovingBody, rows:IntList, place:Vector3D):void
        {
            _core.beginStanding(body, rows, place);
            pushOff(_core, rows, place);
        }

        // Leads a body a clearance off the rows that it touches: see restoreClearance.
        private function pushOff(core:BodyCore, rows:IntList, place:Vector3D):void
        {
            var isFree:Boolean = false;
            var canPush:Boolean = true;
            _before.copyFrom(place);
            _last.setNormal(0, 0, 0);
            for (var round:int = 0; round < ROUNDS && canPush && !isFree; round++)
            {
                isFree = true;
                for (var i:int = 0; i < rows.count && canPush; i++)
                {
                    if (findPushOff(core, rows.numbers[i], place, round, _last, _contact))
                    {
                        isFree = false;
                        canPush = !areOpposite(_contact, _last);
                        _contact.push(place, _contact.depth);
                        _last.copyFrom(_contact);
                    }
                }
            }
            if (!isFree)
            {
                place.copyFrom(_before);
            }
        }

        // Lifts a body out of one obstacle after the other until its core overlaps none. Returns whether it gets free. If not, it is where it was.
        private function lift(start:MotionStart):Boolean
        {
            var body:MovingBody = start.core.body;
            var isFree:Boolean = false;
            var canLift:Boolean = true;
            _before.copyFrom(start.place);
            _last.setNormal(0, 0, 0);
            for (var round:int = 0; round < ROUNDS && canLift && !isFree; round++)
            {
                isFree = true;
                for (var i:int = 0; i < start.obstacles.count && canLift; i++)
                {
                    var row:int = start.obstacles.numbers[i];
                    if (start.core.touches(row, start.place))
                    {
                        findContactInRound(body, row, start.place, round, _last, _contact);
                        isFree = false;
                        canLift = body.isShallow(row, _contact) && !areOpposite(_contact, _last);
                        _contact.push(start.place, _contact.depth + start.core.clearance);
                        _last.copyFrom(_contact);
                        start.lifted.add(_contact, row);
                    }
                }
            }
            if (!isFree)
            {
                start.place.copyFrom(_before);
                start.lifted.clear();
            }
            return isFree;
        }

        // Lets planes stand for obstacles that the core overlaps: for deep overlaps, and also for shallow ones if they are to count. One-way obstacles that the
        // body passes leave too. Returns whether obstacles are left that the core overlapped.
        private function replaceObstacles(start:MotionStart, alsoShallow:Boolean):Boolean
        {
            var body:MovingBody = start.core.body;
            var obstacles:IntList = start.obstacles;
            var isLeft:Boolean = false;
            var i:int = 0;
            while (i < obstacles.count)
            {
                var row:int = obstacles.numbers[i];
                var isOverlapped:Boolean = start.core.touches(row, start.place);
                if (isOverlapped && (body.passesAt(row, start.place) || (findOverlap(body, row, start.place, alsoShallow, _contact) && addPlane(row, start, _contact))))
                {
                    obstacles.remove(row);
                }
                else
                {
                    isLeft ||= isOverlapped;
                    i++;
                }
            }
            return isLeft;
        }

        // Finds the contact of an overlap. Returns whether it counts.
        private static function findOverlap(body:MovingBody, row:int, place:Vector3D, alsoShallow:Boolean, out:ContactPoint):Boolean
        {
            if (alsoShallow)
            {
                body.findSeparatingContact(row, place, out);
                return true;
            }
            body.findContact(row, place, out);
            return !body.isShallow(row, out);
        }

        // Lets a plane stand for a row that the core overlaps, if it is needed. First the core becomes narrower, for the whole motion. If it is free of the
        // row then, no plane is needed. None is needed either if only the core overlaps the row, not the body. Returns whether the plane stands.
        private static function addPlane(row:int, start:MotionStart, contact:ContactPoint):Boolean
        {
            if (start.core.narrow(row, start.place) || !start.core.bodyOverlaps(row, start.place))
            {
                return false;
            }
            start.planes.add(contact, row);
            start.core.body.warnIfInside(row, contact);
            return true;
        }

        // Finds the push off a row that the body touches: along the contact's normal by its depth. Returns whether there is one: not if the body overlaps the
        // row deeply, or passes it.
        private function findPushOff(core:BodyCore, row:int, place:Vector3D, round:int, last:ContactPoint, out:ContactPoint):Boolean
        {
            var body:MovingBody = core.body;
            // mostly it is known faster that the core touches the row than how deep the overlap is
            if (!findTouchingPlace(core, row, place, _touching) || body.passesAt(row, _touching) || (!core.isFlat && core.touches(row, place)))
            {
                return false;
            }
            findContactInRound(body, row, _touching, round, last, out);
            var most:Number = SLOPS_OF_TOUCH * core.slop;
            if (out.depth > most && !body.isShallow(row, out))
            {
                return false;
            }
            _beside.copyFrom(place);
            _beside.decrementBy(_touching);
            out.depth = Math.min(out.depth, most) + core.clearance - out.along(_beside);
            return true;
        }

        // Finds the contact with a row that the body touches at a place.
        private static function findContactInRound(body:MovingBody, row:int, place:Vector3D, round:int, last:ContactPoint, out:ContactPoint):void
        {
            if (round < SURE_ROUND)
            {
                body.findContact(row, place, out);
            }
            if (round >= SURE_ROUND || areOpposite(out, last))
            {
                body.findSeparatingContact(row, place, out);
            }
        }

        // Whether a body that has both contacts is between two rows.
        private static function areOpposite(a:ContactPoint, b:ContactPoint):Boolean
        {
            return a.normalX * b.normalX + a.normalY * b.normalY + a.normalZ * b.normalZ < OPPOSITE;
        }

        // Finds where the body touches a row: at its place, or if it is flat, half of a clearance beside its place along an axis. Returns whether it
        // touches the row at one of these.
        private static function findTouchingPlace(core:BodyCore, row:int, place:Vector3D, touching:Vector3D):Boolean
        {
            if (touchesAt(core, row, place, 0, 0, 0, touching))
            {
                return true;
            }
            var side:Number = -core.clearance / 2;
            for (var i:int = 0; i < 2 && core.isFlat; i++)
            {
                if (touchesAt(core, row, place, 0, 0, side, touching) || touchesAt(core, row, place, 0, side, 0, touching)
                        || touchesAt(core, row, place, side, 0, 0, touching))
                {
                    return true;
                }
                side = -side;
            }
            return false;
        }

        // Sets the touching place to a place moved by x, y and z. Returns whether the body touches a row there.
        private static function touchesAt(core:BodyCore, row:int, place:Vector3D, x:Number, y:Number, z:Number, touching:Vector3D):Boolean
        {
            touching.setTo(place.x + x, place.y + y, place.z + z);
            return core.bodyTouches(row, touching);
        }
    }
}
