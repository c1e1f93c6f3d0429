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

        // Where the pushes begin.
        private var _before:Vector3D = new Vector3D();

        // The contact of this push and of the last one.
        private var _contact:ContactPoint = new ContactPoint();
        private var _last:ContactPoint = new ContactPoint();

        // A place where the body touches a row, and the way from there to the place of the body.
        private var _touching:Vector3D = new Vector3D();
        private var _beside:Vector3D = new Vector3D();

        /**
         * Frees the core of a body from the obstacles that it overlaps where its motion begins. An obstacle for which a plane stands is none from then
         * on.
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
         * Leads a body a clearance off the obstacles of its last motion that it touches, if there is room; a flat body also off those that it is close to.
         *
         * @param place the place of the body, which changes
         */
        public function restoreClearance(body:MovingBody, place:Vector3D):void
        {
            pushFree(body, place, null);
        }

        // Lets planes stand for obstacles that the core overlaps: for those whose overlap is deep, or for all. One-way obstacles that the body passes leave
        // too. Returns whether obstacles are left that the core overlapped.
        private function replaceDeep(body:MovingBody, place:Vector3D, planes:SlidePlanes, isOfAll:Boolean):Boolean
        {
            var obstacles:IntList = body.obstacles;
            var isLeft:Boolean = false;
            var kept:int = 0;
            for (var i:int = 0; i < obstacles.count; i++)
            {
                var row:int = obstacles.numbers[i];
                var isOverlapped:Boolean = body.coreTouches(row, place);
                if (isOverlapped && body.passesAt(row, place))
                {
                    continue;
                }
                if (isOverlapped && findDeep(body, row, place, isOfAll, _contact))
                {
                    planes.add(_contact, row);
                    body.warnIfInside(row, _contact);
                    continue;
                }
                isLeft ||= isOverlapped;
                obstacles.numbers[kept] = row;
                kept++;
            }
            obstacles.count = kept;
            return isLeft;
        }

        // Finds the contact whose plane has to stand for an obstacle that the core overlaps. There is none in three cases. The overlap is shallow, and not
        // all count. A narrower core is free of the obstacle: then the motion has this core. Only the core overlaps the obstacle, not the body.
        private function findDeep(body:MovingBody, row:int, place:Vector3D, isOfAll:Boolean, out:ContactPoint):Boolean
        {
            var isShallow:Boolean = body.findContact(row, place, isOfAll, out);
            return (isOfAll || !isShallow) && !body.core.narrow(body, row, place) && body.overlaps(row, place);
        }

        // Pushes a body out of one obstacle after the other until it needs no push: out of those that its core overlaps, with a lift, which receives the
        // contacts; or if the lift is null, off those that it touches. Returns whether the body gets free. If not, it is where it was.
        private function pushFree(body:MovingBody, place:Vector3D, lift:StartLift):Boolean
        {
            _before.copyFrom(place);
            _last.setNormal(0, 0, 0);
            for (var round:int = 0; round < ROUNDS; round++)
            {
                var isFree:Boolean = true;
                for (var i:int = 0; i < body.obstacles.count; i++)
                {
                    var row:int = body.obstacles.numbers[i];
                    var isPushed:Boolean = lift == null ? findPushOff(body, row, place, round, _contact) : findPushOut(body, row, place, round, _contact);
                    if (!isPushed)
                    {
                        continue;
                    }
                    if (_contact.depth == Infinity || isOpposite(_contact))
                    {
                        place.copyFrom(_before);
                        return false;
                    }
                    isFree = false;
                    _contact.push(place, _contact.depth);
                    _last.copyFrom(_contact);
                    if (lift != null)
                    {
                        lift.add(_contact);
                    }
                }
                if (isFree)
                {
                    return true;
                }
            }
            place.copyFrom(_before);
            return false;
        }

        // Finds the push out of a row that the core overlaps: along a contact's normal by its depth, which is Infinity if the overlap is not shallow.
        // Returns whether the core overlaps the row.
        private function findPushOut(body:MovingBody, row:int, place:Vector3D, round:int, out:ContactPoint):Boolean
        {
            if (!body.coreTouches(row, place))
            {
                return false;
            }
            var isShallow:Boolean = findContactInRound(body, row, place, round, out);
            out.depth = isShallow ? out.depth + body.core.clearance : Infinity;
            return true;
        }

        // Finds the push off a row that the body touches. Returns whether it touches the row.
        private function findPushOff(body:MovingBody, row:int, place:Vector3D, round:int, out:ContactPoint):Boolean
        {
            if (!findTouchingPlace(body, row, place, _touching))
            {
                return false;
            }
            findContactInRound(body, row, _touching, round, out);
            _beside.copyFrom(place);
            _beside.decrementBy(_touching);
            out.depth = Math.min(out.depth, SLOPS_OF_TOUCH * body.core.slop) + body.core.clearance - out.along(_beside);
            return true;
        }

        // Finds the contact with a row that the body touches at a place. Returns whether it is shallow.
        private function findContactInRound(body:MovingBody, row:int, place:Vector3D, round:int, out:ContactPoint):Boolean
        {
            var isShallow:Boolean = body.findContact(row, place, round >= SURE_ROUND, out);
            if (round < SURE_ROUND && isOpposite(out))
            {
                isShallow = body.findContact(row, place, true, out);
            }
            return isShallow;
        }

        // Whether the body is between this row and the one that it was last pushed out of.
        private function isOpposite(contact:ContactPoint):Boolean
        {
            return contact.normalX * _last.normalX + contact.normalY * _last.normalY + contact.normalZ * _last.normalZ < OPPOSITE;
        }

        // Finds where the body touches a row: at its place, or if it is flat, half of a clearance beside its place along an axis. Returns whether it
        // touches the row at one of these.
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
