package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.intersection.contact.ContactPoint;

    /**
     * Lifts a row by the clearance off the rows that it only touches at the end of a motion, and a flat row off those that it is close to. In a
     * hollow, a lift off one side leads a part of the way into another, so this takes several rounds.
     *
     * @private
     */
    public final class EndClearance
    {
        private static const ROUNDS:int = 30;

        // If a row only touches another, it is never this many slops deep in it.
        private static const MOST_SLOPS:Number = 2;

        // Two normals are the same if the cosine of the angle between them is greater than this, and opposite if it is less than the negative.
        private static const SAME:Number = 0.999;

        private var _before:Vector3D = new Vector3D();
        private var _contact:ContactPoint = new ContactPoint();

        // The place where the row touches another, and its way from there.
        private var _touching:Vector3D = new Vector3D();
        private var _beside:Vector3D = new Vector3D();

        // The contact of the last lift, and whether the row is between that one and an opposite one.
        private var _last:ContactPoint = new ContactPoint();
        private var _isBetween:Boolean = false;

        /**
         * Lifts a row. If that does not free it, for example between two opposite walls, it stays.
         *
         * @param sweep has the row
         * @param at the row's place, which changes
         * @param others the rows that it may touch
         * @param count the number of the others
         * @param clear one of them that the row is known not to touch at its place; -1 for none
         */
        public function restoreClearance(sweep:CoreSweep, at:Vector3D, others:Vector.<int>, count:int, clear:int):void
        {
            _before.copyFrom(at);
            _last.setNormal(0, 0, 0);
            _isBetween = false;
            var isFree:Boolean = false;
            for (var round:int = 0; !isFree && !_isBetween && round < ROUNDS; round++)
            {
                isFree = lift(sweep, at, others, count, round == 0 ? clear : -1);
            }
            if (!isFree)
            {
                at.copyFrom(_before);
            }
        }

        // Lifts the row off some rows. Returns whether it touched none of them.
        private function lift(sweep:CoreSweep, at:Vector3D, rows:Vector.<int>, count:int, clear:int):Boolean
        {
            var isFree:Boolean = true;
            for (var i:int = 0; i < count; i++)
            {
                if (rows[i] != clear && isClose(sweep, at, rows[i]))
                {
                    isFree = false;
                    sweep.findContact(rows[i], _touching, _contact);
                    var cosine:Number = _contact.normalX * _last.normalX + _contact.normalY * _last.normalY + _contact.normalZ * _last.normalZ;
                    _isBetween = cosine < -SAME;
                    if (cosine > SAME && _contact.depth >= _last.depth)
                    {
                        // the contact of two parts leads into another part
                        sweep.findContact(rows[i], _touching, _contact, true);
                    }
                    _last.copyFrom(_contact);
                    _beside.copyFrom(at);
                    _beside.decrementBy(_touching);
                    _contact.push(at, Math.min(_contact.depth, MOST_SLOPS * sweep.slop) + sweep.clearance - _contact.along(_beside));
                }
            }
            return isFree;
        }

        // Whether the row touches another at a place, or is flat and so close to it that it touches it beside. Writes where it touches it.
        private function isClose(sweep:CoreSweep, at:Vector3D, row:int):Boolean
        {
            _touching.copyFrom(at);
            return sweep.wholeTouchesAt(row, at) || sweep.isFlat && sweep.isCloseAt(row, at, _touching);
        }
    }
}
