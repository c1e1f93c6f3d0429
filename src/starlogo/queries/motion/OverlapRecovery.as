package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.warnOfInside;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.penetration.OverlapMiddle;

    use namespace engine;

    /**
     * Moves a body out of what it overlaps or touches: at the beginning of a motion (leaveOverlaps), and at its end off what it only touches
     * (restoreClearance). It also finds the deepest overlap, which a walk pushes the body out of.
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

        // A body that is this many times half of its extent inside of a structure is inside with room to spare. Two equal ones in one place are not.
        private static const WITH_ROOM:Number = 2.1;

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
         * @param planes receives the planes of deep overlaps. They belong to no corner
         * @param lift what the body is lifted out of already; receives the whole lift
         * @param place receives where the body then is
         */
        public function leaveOverlaps(body:MovingBody, from:Vector3D, planes:SlidePlanes, lift:StartLift, place:Vector3D):void
        {
            place.copyFrom(from);
            place.incrementBy(lift.displacement);
            lift.mostDepth = SLOPS_TO_LEAVE * body.core.slop;
            if (replaceDeep(body, place, planes, false) && !liftOut(body, place, lift))
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
            beginPushes(place);
            for (var round:int = 0; round < ROUNDS; round++)
            {
                var isFree:Boolean = true;
                for (var i:int = 0; i < body.obstacles.count; i++)
                {
                    var row:int = body.obstacles.numbers[i];
                    if (!findTouchingPlace(body, row, place, _touching))
                    {
                        continue;
                    }
                    isFree = false;
                    findContactInRound(body, row, _touching, round, _contact);
                    if (isOpposite(_contact))
                    {
                        giveUp(place);
                        return;
                    }
                    _beside.copyFrom(place);
                    _beside.decrementBy(_touching);
                    push(place, _contact, Math.min(_contact.depth, SLOPS_OF_TOUCH * body.core.slop) + body.core.clearance - _contact.along(_beside));
                }
                if (isFree)
                {
                    return;
                }
            }
            giveUp(place);
        }

        /**
         * Finds the deepest overlap of a body with some rows. An overlap that a motion only lifts out of does not count, nor one with a one-way row.
         *
         * @param out receives the contact. A push along its normal by its depth leads a clearance out of the row
         * @return the sum of the depths of all overlaps; 0 if there is none
         */
        public function findDeepest(body:MovingBody, rows:IntList, place:Vector3D, out:ContactPoint):Number
        {
            var sum:Number = 0;
            out.depth = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.numbers[i];
                if (body.isOneWay(row) || !body.coreTouches(row, place) || body.findContact(row, place, true, _contact) || !body.overlaps(row, place))
                {
                    continue;
                }
                warnIfInside(body, row, _contact);
                _contact.depth += body.core.clearance;
                if (isExitShort(body, row, _contact))
                {
                    sum += _contact.depth;
                    if (_contact.depth > out.depth)
                    {
                        out.copyFrom(_contact);
                    }
                }
            }
            return sum;
        }

        // Whether a contact leads out of a row by a short way. The shortest way out of a tree may lead through a wall of the tree if it is longer than the
        // way to the middle of the body.
        private static function isExitShort(body:MovingBody, row:int, contact:ContactPoint):Boolean
        {
            return body.bodyOf(row).form != ModelShape.TREE || contact.depth <= OverlapMiddle.halfAlong(body.source, contact);
        }

        // Warns of a motion that begins so deep inside of a tree that the tree does not stop it: in a closed room, for example, which is solid. Warns
        // too of one that begins with all of the body inside of another structure, and with room to spare, as that around a level.
        private static function warnIfInside(body:MovingBody, row:int, contact:ContactPoint):void
        {
            var form:int = body.bodyOf(row).form;
            var isTree:Boolean = form == ModelShape.TREE;
            var source:Body = body.source;
            var least:Number = OverlapMiddle.halfAlong(source, contact);
            if (!isTree)
            {
                least *= WITH_ROOM;
            }
            if (form != ModelShape.GROUND && contact.depth > least)
            {
                var below:Number = source.placement.r22 == 1 ? source.halfZ - source.offsetZ : 0;
                warnOfInside(body.agents, row, source.shape.modelName, source.placement, below, contact.depth, isTree);
            }
        }

        // Lets planes take the places of rows that the core overlaps: of those whose overlap is not shallow, or of all. If the core does not
        // touch a row when it is narrower, the row stays, and the motion has that core. One-way rows that the body is within do not count any
        // more. Returns whether rows are left that the core overlapped.
        private function replaceDeep(body:MovingBody, place:Vector3D, planes:SlidePlanes, isOfAll:Boolean):Boolean
        {
            var obstacles:IntList = body.obstacles;
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
                    warnIfInside(body, row, _contact);
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

        // Lifts a body out of obstacles whose overlap with its core is shallow. The lift receives their contacts. Returns whether the core touches no
        // obstacle at its place.
        private function liftOut(body:MovingBody, place:Vector3D, lift:StartLift):Boolean
        {
            beginPushes(place);
            for (var round:int = 0; round < ROUNDS; round++)
            {
                var isFree:Boolean = true;
                for (var i:int = 0; i < body.obstacles.count; i++)
                {
                    var row:int = body.obstacles.numbers[i];
                    if (!body.coreTouches(row, place))
                    {
                        continue;
                    }
                    isFree = false;
                    var isShallow:Boolean = findContactInRound(body, row, place, round, _contact);
                    if (!isShallow || isOpposite(_contact))
                    {
                        return giveUp(place);
                    }
                    lift.add(_contact);
                    push(place, _contact, _contact.depth + body.core.clearance);
                }
                if (isFree)
                {
                    return true;
                }
            }
            return giveUp(place);
        }

        private function beginPushes(place:Vector3D):void
        {
            _before.copyFrom(place);
            _last.setNormal(0, 0, 0);
        }

        // Goes back to where the pushes began. Returns false: the body does not get free.
        private function giveUp(place:Vector3D):Boolean
        {
            place.copyFrom(_before);
            return false;
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

        private function push(place:Vector3D, contact:ContactPoint, by:Number):void
        {
            contact.push(place, by);
            _last.copyFrom(contact);
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
