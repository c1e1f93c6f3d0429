package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.search.NumberList;

    /**
     * Moves a body out of what it overlaps or touches: at the beginning of a motion out of shallow overlaps, at its end off what it only touches.
     * It also finds the deepest overlap, which a walk pushes the body out of.
     *
     * <p>It pushes the body out of one row after the other, in rounds, because a push out of one side of a hollow leads a part of the way into
     * another. If the body does not get free, for example between two opposite walls, it stays where it was.</p>
     *
     * @private
     */
    public final class OverlapRecovery
    {
        private static const ROUNDS:int = 30;

        // From this round on contacts have to separate. Contacts of parts of a body may point sideways, round after round.
        private static const SURE_ROUND:int = 2;

        // If a body only touches a row, it is never this many slops deep in it.
        private static const MOST_SLOPS:Number = 2;

        // Two normals are opposite if the cosine of the angle between them is less than this.
        private static const OPPOSITE:Number = -0.999;

        private var _body:MovingBody;
        private var _before:Vector3D = new Vector3D();

        // The contact of this push and of the last one.
        private var _contact:ContactPoint = new ContactPoint();
        private var _last:ContactPoint = new ContactPoint();

        // A place where the body touches a row, and the way from there to the place of the body.
        private var _touching:Vector3D = new Vector3D();
        private var _beside:Vector3D = new Vector3D();

        /** @param body the body that moves */
        public function OverlapRecovery(body:MovingBody)
        {
            _body = body;
        }

        /**
         * Lifts the body out of rows whose overlap with its core is shallow.
         *
         * @param rows the rows
         * @param place the place of the body, which changes
         * @param lift the contacts are added to it
         * @return whether the core touches no row at its place
         */
        public function liftOut(rows:NumberList, place:Vector3D, lift:StartLift):Boolean
        {
            return leave(rows, place, -1, lift);
        }

        /**
         * Lifts the body by the clearance off rows that it only touches, and a flat body off rows that it is close to.
         *
         * @param rows the rows
         * @param place the place of the body, which changes
         * @param clearRow one of them that the body is known not to touch at its place; -1 for none
         */
        public function restoreClearance(rows:NumberList, place:Vector3D, clearRow:int):void
        {
            leave(rows, place, clearRow, null);
        }

        /**
         * Finds the deepest overlap of the body with some rows. An overlap that a motion only lifts out of does not count.
         *
         * @param out receives the contact and the sum of the depths
         * @return whether there is one
         */
        public function findDeepest(rows:NumberList, place:Vector3D, out:Overlap):Boolean
        {
            out.contact.depth = out.sum = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.numbers[i];
                if (!_body.coreTouches(row, place) || _body.findContact(row, place, true, _contact) || !_body.overlaps(row, place))
                {
                    continue;
                }
                _contact.depth += _body.clearance;
                if (_body.isWayShort(row, _contact))
                {
                    out.sum += _contact.depth;
                    if (_contact.depth > out.contact.depth)
                    {
                        out.contact.copyFrom(_contact);
                    }
                }
            }
            return out.sum > 0;
        }

        // Pushes the place out of rows until it is free of them: of their overlaps with the core, whose contacts are added to a lift; or
        // without a lift, of all touches.
        private function leave(rows:NumberList, place:Vector3D, clearRow:int, lift:StartLift):Boolean
        {
            _before.copyFrom(place);
            _last.setNormal(0, 0, 0);
            var isFree:Boolean = false;
            var isStuck:Boolean = false;
            for (var round:int = 0; !isFree && !isStuck && round < ROUNDS; round++)
            {
                isFree = true;
                for (var i:int = 0; i < rows.count && !isStuck; i++)
                {
                    var row:int = rows.numbers[i];
                    _touching.copyFrom(place);
                    if (lift != null && _body.coreTouches(row, place))
                    {
                        isFree = false;
                        isStuck = !findPush(row, round) || isOpposite();
                        _contact.push(place, _contact.depth + _body.clearance);
                        lift.add(_contact);
                        _last.copyFrom(_contact);
                    }
                    else if (lift == null && !(round == 0 && row == clearRow) && isClose(row, place, _touching))
                    {
                        isFree = false;
                        findPush(row, round);
                        isStuck = isOpposite();
                        _beside.copyFrom(place);
                        _beside.decrementBy(_touching);
                        _contact.push(place, Math.min(_contact.depth, MOST_SLOPS * _body.slop) + _body.clearance - _contact.along(_beside));
                        _last.copyFrom(_contact);
                    }
                }
            }
            if (!isFree)
            {
                place.copyFrom(_before);
            }
            return isFree;
        }

        // Finds the contact with a row at the place where the body touches it. Returns whether it is shallow.
        private function findPush(row:int, round:int):Boolean
        {
            var isShallow:Boolean = _body.findContact(row, _touching, round >= SURE_ROUND, _contact);
            return round < SURE_ROUND && isOpposite() ? _body.findContact(row, _touching, true, _contact) : isShallow;
        }

        private function isOpposite():Boolean
        {
            return _contact.normalX * _last.normalX + _contact.normalY * _last.normalY + _contact.normalZ * _last.normalZ < OPPOSITE;
        }

        // Whether the body touches a row at a place, or is flat and so close to it that it touches it half of a clearance beside the place, along
        // an axis. Then the touching place is moved there.
        private function isClose(row:int, place:Vector3D, touching:Vector3D):Boolean
        {
            if (_body.touches(row, place))
            {
                return true;
            }
            for (var side:Number = -_body.clearance / 2; _body.isFlat && side <= _body.clearance / 2; side += _body.clearance)
            {
                touching.setTo(place.x, place.y, place.z + side);
                if (_body.touches(row, touching))
                {
                    return true;
                }
                touching.setTo(place.x, place.y + side, place.z);
                if (_body.touches(row, touching))
                {
                    return true;
                }
                touching.setTo(place.x + side, place.y, place.z);
                if (_body.touches(row, touching))
                {
                    return true;
                }
            }
            return false;
        }
    }
}
