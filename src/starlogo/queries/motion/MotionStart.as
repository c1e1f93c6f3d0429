package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.NumberList;

    /**
     * Begins motions of bodies that overlap rows already. Out of shallow overlaps the body is lifted (OverlapRecovery), because they come from rounding
     * in the game. If it overlaps a row more deeply, the plane of their contact stands for that row. The motion must not cross the plane, and nothing
     * else of that row counts.
     *
     * @private
     */
    public final class MotionStart
    {
        // If a motion leads this many slops deeper into what it was lifted out of, the body has left the surface. Otherwise its core would meet it.
        private static const SLOPS_TO_LEAVE:Number = 2;

        private var _recovery:OverlapRecovery = new OverlapRecovery();

        // The contact with a row that the core overlaps.
        private var _contact:ContactPoint = new ContactPoint();

        /**
         * Frees the core of a body from the obstacles that it overlaps where its motion begins. The obstacles whose places planes take are no
         * obstacles any more.
         *
         * @param from where the motion begins
         * @param planes receives the planes of deep overlaps. They belong to no corner
         * @param lift what the body is lifted out of already; receives the whole lift
         * @param place receives where the body then is
         */
        public function leaveOverlaps(body:MovingBody, from:Vector3D, planes:SlidePlanes, lift:StartLift, place:Vector3D):void
        {
            place.copyFrom(from);
            place.incrementBy(lift.displacement);
            lift.mostDepth = SLOPS_TO_LEAVE * body.core.slop;
            if (replaceDeep(body, place, planes, false) && !_recovery.liftOut(body, place, lift))
            {
                place.copyFrom(from);
                lift.clear();
                replaceDeep(body, place, planes, true);
            }
            if (body.core.isFlat && planes.count == 0)
            {
                // its core is as flat, and a sweep touches across a wider gap than a body that stands
                _recovery.restoreClearance(body, place, -1);
            }
            lift.displacement.copyFrom(place);
            lift.displacement.decrementBy(from);
            planes.beginCorner();
        }

        // Lets planes take the places of rows that the core overlaps: of those whose overlap is not shallow, or of all. If the core does not
        // touch a row when it is narrower, the row stays, and the motion has that core. One-way rows that the body is within do not count any
        // more. Returns whether rows are left that the core overlapped.
        private function replaceDeep(body:MovingBody, place:Vector3D, planes:SlidePlanes, isOfAll:Boolean):Boolean
        {
            var obstacles:NumberList = body.obstacles;
            var isLeft:Boolean = false;
            var kept:int = 0;
            for (var i:int = 0; i < obstacles.count; i++)
            {
                var row:int = obstacles.numbers[i];
                var touches:Boolean = body.coreTouches(row, place);
                if (touches && isWithinOneWay(body, row, place))
                {
                    continue;
                }
                if (touches && narrowOrFindDeep(body, row, place, isOfAll, _contact))
                {
                    planes.add(_contact, row);
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

        // Whether the body is within a one-way row, which its core touches. If it rests on the row, it is not.
        private function isWithinOneWay(body:MovingBody, row:int, place:Vector3D):Boolean
        {
            return body.isOneWay(row) && (!body.findContact(row, place, true, _contact) || body.passes(row, _contact));
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
    }
}
