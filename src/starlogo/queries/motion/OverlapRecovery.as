package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;

    /**
     * Moves a body out of what it overlaps or touches: at the beginning of a motion (leaveOverlaps), and at its end off what it only touches
     * (restoreClearance). RowOverlap says how it overlaps a row.
     *
     * <p>Out of shallow overlaps the body is lifted, because they come from rounding in the game. If it overlaps a row more deeply, the plane of their
     * contact stands for that row. The motion must not cross the plane, and nothing else of that row counts.</p>
     *
     * <p>It pushes the body out of one row after the other, in rounds, because a push out of one side of a hollow leads a part of the way into
     * another. If the body does not get free, for example between two opposite walls, it stays where it was. The tests of a pair know the
     * shortest way out of that pair (PairTests.separate).</p>
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

        // If a motion leads this many slops deeper into what it was lifted out of, the body has left the surface. Otherwise its core would meet it.
        private static const SLOPS_TO_LEAVE:Number = 2;

        // Two normals are opposite if the cosine of the angle between them is less than this.
        private static const OPPOSITE:Number = -0.999;

        // What becomes of a body at one row: it is free of the row, is pushed out of it, or does not get out.
        private static const FREE:int = 0;
        private static const PUSHED:int = 1;
        private static const STUCK:int = 2;

        private var _overlap:RowOverlap = new RowOverlap();

        // Where the pushes begin.
        private var _before:Vector3D = new Vector3D();

        // The contact of this push and of the last one.
        private var _contact:ContactPoint = new ContactPoint();
        private var _last:ContactPoint = new ContactPoint();

        // A place where the body touches a row, and the way from there to the place of the body.
        private var _touching:Vector3D = new Vector3D();
        private var _beside:Vector3D = new Vector3D();

        /**
         * Frees the core of a body from the obstacles that it overlaps where its motion begins. The obstacles whose places planes take are no
         * obstacles any more.
         *
         * @param from where the motion begins
         * @param planes receives the planes of deep overlaps, before its first corner
         * @param lift what the body is lifted out of already; receives the whole lift, and where the body then is
         */
        public function leaveOverlaps(body:MovingBody, from:Vector3D, planes:SlidePlanes, lift:StartLift):void
        {
            var place:Vector3D = lift.place;
            place.copyFrom(from);
            place.incrementBy(lift.displacement);
            lift.mostDepth = SLOPS_TO_LEAVE * body.core.slop;
            if (replaceDeep(body, place, planes, false) && !pushFree(body, place, lift))
            {
                place.copyFrom(from);
                lift.clear();
                replaceDeep(body, place, planes, true);
            }
            if (body.core.isFlat && planes.count == 0)
            {
                // its core is as flat, and a sweep touches across a wider gap than a body that stands
                restoreClearance(body, place);
            }
            lift.displacement.copyFrom(place);
            lift.displacement.decrementBy(from);
            planes.beginCorner();
        }

        /**
         * Lifts a body by the clearance off obstacles that it only touches, and a flat body off obstacles that it is close to, if there is room.
         *
         * @param place the place of the body, which changes
         */
        public function restoreClearance(body:MovingBody, place:Vector3D):void
        {
            pushFree(body, place, null);
        }

        // Lets planes take the places of obstacles that the core overlaps: of those whose overlap is deep, or of all. Obstacles that the body passes do
        // not count any more. Returns whether obstacles are left that the core overlapped.
        private function replaceDeep(body:MovingBody, place:Vector3D, planes:SlidePlanes, isOfAll:Boolean):Boolean
        {
            var obstacles:IntList = body.obstacles;
            var isLeft:Boolean = false;
            var kept:int = 0;
            for (var i:int = 0; i < obstacles.count; i++)
            {
                var row:int = obstacles.numbers[i];
                var isOverlapped:Boolean = body.coreTouches(row, place);
                if (isOverlapped && _overlap.isPassed(body, row, place))
                {
                    continue;
                }
                if (isOverlapped && findDeep(body, row, place, isOfAll, _contact))
                {
                    planes.add(_contact, row);
                    RowOverlap.warnIfInside(body, row, _contact);
                    continue;
                }
                isLeft ||= isOverlapped;
                obstacles.numbers[kept] = row;
                kept++;
            }
            obstacles.count = kept;
            return isLeft;
        }

        // Finds the contact whose plane has to take the place of an obstacle that the core touches. Returns false if there is none: if the overlap is
        // shallow, unless all count, if a narrower core is free of the obstacle, which the motion then has, or if the core overlaps it, but not the body.
        private function findDeep(body:MovingBody, row:int, place:Vector3D, isOfAll:Boolean, out:ContactPoint):Boolean
        {
            var isShallow:Boolean = _overlap.findContact(body, row, place, isOfAll, out);
            if (isShallow && !isOfAll)
            {
                return false;
            }
            return !body.core.narrow(body, row, place) && _overlap.wholeOverlaps(body, row, place);
        }

        // Pushes a body out of one obstacle after the other, until it needs no push: with a lift, which receives the contacts, out of those that its core
        // overlaps a little, and without one off those that it touches. Returns whether it gets free. If not, it is where it was.
        private function pushFree(body:MovingBody, place:Vector3D, lift:StartLift):Boolean
        {
            _before.copyFrom(place);
            _last.setNormal(0, 0, 0);
            var result:int = PUSHED;
            for (var round:int = 0; round < ROUNDS && result == PUSHED; round++)
            {
                result = FREE;
                for (var i:int = 0; i < body.obstacles.count && result != STUCK; i++)
                {
                    var row:int = body.obstacles.numbers[i];
                    var ofRow:int = lift == null ? pushOff(body, row, place, round) : liftOut(body, row, place, round, lift);
                    if (ofRow != FREE)
                    {
                        result = ofRow;
                        _last.copyFrom(_contact);
                    }
                }
            }
            if (result != FREE)
            {
                place.copyFrom(_before);
            }
            return result == FREE;
        }

        // Lifts a body by the clearance out of a row that its core overlaps a little.
        private function liftOut(body:MovingBody, row:int, place:Vector3D, round:int, lift:StartLift):int
        {
            if (!body.coreTouches(row, place))
            {
                return FREE;
            }
            var isShallow:Boolean = findContactInRound(body, row, place, round, _contact);
            if (!isShallow || isOpposite(_contact))
            {
                return STUCK;
            }
            lift.add(_contact);
            _contact.push(place, _contact.depth + body.core.clearance);
            return PUSHED;
        }

        // Pushes a body by the clearance off a row that it touches.
        private function pushOff(body:MovingBody, row:int, place:Vector3D, round:int):int
        {
            if (!findTouchingPlace(body, row, place, _touching))
            {
                return FREE;
            }
            findContactInRound(body, row, _touching, round, _contact);
            if (isOpposite(_contact))
            {
                return STUCK;
            }
            _beside.copyFrom(place);
            _beside.decrementBy(_touching);
            _contact.push(place, Math.min(_contact.depth, SLOPS_OF_TOUCH * body.core.slop) + body.core.clearance - _contact.along(_beside));
            return PUSHED;
        }

        // Finds the contact with a row that the body touches at a place. Returns whether it is shallow.
        private function findContactInRound(body:MovingBody, row:int, place:Vector3D, round:int, out:ContactPoint):Boolean
        {
            var isShallow:Boolean = _overlap.findContact(body, row, place, round >= SURE_ROUND, out);
            if (round < SURE_ROUND && isOpposite(out))
            {
                isShallow = _overlap.findContact(body, row, place, true, out);
            }
            return isShallow;
        }

        // Whether the body is between this row and the one that it was last pushed out of.
        private function isOpposite(contact:ContactPoint):Boolean
        {
            return contact.normalX * _last.normalX + contact.normalY * _last.normalY + contact.normalZ * _last.normalZ < OPPOSITE;
        }

        // Finds where the body touches a row: at a place, or, if it is flat, half of a clearance beside the place along an axis. Returns whether
        // there is such a touching place.
        private function findTouchingPlace(body:MovingBody, row:int, place:Vector3D, touching:Vector3D):Boolean
        {
            if (touchesAt(body, row, place, 0, 0, 0, touching))
            {
                return true;
            }
            var side:Number = -body.core.clearance / 2;
            for (var i:int = 0; i < 2 && body.core.isFlat; i++)
            {
                if (touchesAt(body, row, place, 0, 0, side, touching) || touchesAt(body, row, place, 0, side, 0, touching)
                        || touchesAt(body, row, place, side, 0, 0, touching))
                {
                    return true;
                }
                side = -side;
            }
            return false;
        }

        // Sets the touching place to a place moved by x, y and z. Returns whether the body touches a row there.
        private function touchesAt(body:MovingBody, row:int, place:Vector3D, x:Number, y:Number, z:Number, touching:Vector3D):Boolean
        {
            touching.setTo(place.x + x, place.y + y, place.z + z);
            return body.touches(row, touching);
        }
    }
}
