package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.NumberList;

    /**
     * Moves a body out of what it overlaps or touches: at the beginning of a motion out of shallow overlaps, at its end off what it only touches.
     * It also finds the deepest overlap, which a walk pushes the body out of.
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
            return pushOutOf(rows, place, -1, lift);
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
            pushOutOf(rows, place, clearRow, null);
        }

        /**
         * Finds the deepest overlap of the body with some rows. An overlap that a motion only lifts out of does not count, nor one with a one-way row.
         *
         * @param out receives the contact. A push along its normal by its depth leads a clearance out of the row
         * @return the sum of the depths of all overlaps; 0 if there is none
         */
        public function findDeepest(rows:NumberList, place:Vector3D, out:ContactPoint):Number
        {
            var sum:Number = 0;
            out.depth = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.numbers[i];
                if (_body.isOneWay(row) || !_body.coreTouches(row, place) || _body.findContact(row, place, true, _contact) || !_body.overlaps(row, place))
                {
                    continue;
                }
                _contact.depth += _body.setup.clearance;
                if (_body.isExitShort(row, _contact))
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

        // Pushes the place out of rows until it is free of them: of their overlaps with the core, whose contacts are added to a lift; or
        // without a lift, of all touches. Returns whether it gets free.
        private function pushOutOf(rows:NumberList, place:Vector3D, clearRow:int, lift:StartLift):Boolean
        {
            _before.copyFrom(place);
            _last.setNormal(0, 0, 0);
            for (var round:int = 0; round < ROUNDS; round++)
            {
                var isFree:Boolean = true;
                for (var i:int = 0; i < rows.count; i++)
                {
                    var row:int = rows.numbers[i];
                    if (row == clearRow && round == 0)
                    {
                        continue;
                    }
                    var isIn:Boolean = lift == null ? findTouch(row, place, _touching) : findCoreTouch(row, place, _touching);
                    if (!isIn)
                    {
                        continue;
                    }
                    isFree = false;
                    if (!push(row, round, place, _touching, lift))
                    {
                        place.copyFrom(_before);
                        return false;
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

        // Pushes the place out of a row, which the body touches at another place. Returns false if the body is between this row and the last one, or
        // too deep for a lift.
        private function push(row:int, round:int, place:Vector3D, touching:Vector3D, lift:StartLift):Boolean
        {
            var isShallow:Boolean = _body.findContact(row, touching, round >= SURE_ROUND, _contact);
            if (round < SURE_ROUND && isOpposite())
            {
                isShallow = _body.findContact(row, touching, true, _contact);
            }
            if (isOpposite() || (lift != null && !isShallow))
            {
                return false;
            }
            var depth:Number = _contact.depth;
            if (lift == null)
            {
                depth = Math.min(depth, SLOPS_OF_TOUCH * _body.setup.slop);
            }
            else
            {
                lift.add(_contact);
            }
            _beside.copyFrom(place);
            _beside.decrementBy(touching);
            _contact.push(place, depth + _body.setup.clearance - _contact.along(_beside));
            _last.copyFrom(_contact);
            return true;
        }

        private function isOpposite():Boolean
        {
            return _contact.normalX * _last.normalX + _contact.normalY * _last.normalY + _contact.normalZ * _last.normalZ < OPPOSITE;
        }

        // Sets the touching place to a place. Returns whether the core touches a row there.
        private function findCoreTouch(row:int, place:Vector3D, touching:Vector3D):Boolean
        {
            touching.copyFrom(place);
            return _body.coreTouches(row, place);
        }

        // Finds where the body touches a row: at a place, or, if it is flat, half of a clearance beside the place along an axis. Returns whether
        // there is such a touching place.
        private function findTouch(row:int, place:Vector3D, touching:Vector3D):Boolean
        {
            if (touchesAt(row, place, 0, 0, 0, touching))
            {
                return true;
            }
            for (var side:Number = -_body.setup.clearance / 2; _body.setup.isFlat && side <= _body.setup.clearance / 2; side += _body.setup.clearance)
            {
                if (touchesAt(row, place, 0, 0, side, touching) || touchesAt(row, place, 0, side, 0, touching) || touchesAt(row, place, side, 0, 0, touching))
                {
                    return true;
                }
            }
            return false;
        }

        // Sets the touching place to a place moved by x, y and z. Returns whether the body touches a row there.
        private function touchesAt(row:int, place:Vector3D, x:Number, y:Number, z:Number, touching:Vector3D):Boolean
        {
            touching.setTo(place.x + x, place.y + y, place.z + z);
            return _body.touches(row, touching);
        }
    }
}
