package starlogo.search
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;

    use namespace engine;

    /** Finds how two agents touch: where they are, or where they first touch on their motions. */
    internal final class PairContacts
    {
        private var _narrowPhase:NarrowPhase;
        private var _motions:RowMotions;

        // The motion of the first of the two, relative to the second.
        private var _motion:RelativeMotion = new RelativeMotion();

        /**
         * @param narrowPhase tests bodies
         * @param motions of the rows
         */
        public function PairContacts(narrowPhase:NarrowPhase, motions:RowMotions)
        {
            _narrowPhase = narrowPhase;
            _motions = motions;
        }

        /**
         * Finds the contact of two rows, on their motions if one of the two sweeps.
         *
         * @param b may be the ground or the edges of the world
         * @param out receives the contact
         */
        public function findOnMotions(table:AgentTable, a:int, b:int, out:FoundContact):void
        {
            if (_motions.isSwept(a, b))
            {
                _motions.findTime(table, null, a, b, _motion, out.point);
                if (_motion.time != RelativeMotion.NEVER)
                {
                    separate(table.bodyOf(a), table.bodyOf(b), out);
                    // the motion was relative to b at its present place, so the point is moved back to where b was at that time
                    _motions.moveBack(b, 1 - out.time, out.point);
                    return;
                }
            }
            findStanding(table.bodyOf(a), table.bodyOf(b), out);
        }

        /** Finds the contact of two bodies where they are. */
        public function findStanding(a:Body, b:Body, out:FoundContact):void
        {
            _motion.endAfter(0, 0, 0);
            _motion.time = 1;
            _narrowPhase.testsOf(a, b).findContact(a, b, _motion, out.point);
            separate(a, b, out);
        }

        // Makes a contact at the motion's time separate the two.
        private function separate(a:Body, b:Body, out:FoundContact):void
        {
            var motion:RelativeMotion = _motion;
            var point:ContactPoint = out.point;
            _narrowPhase.testsOf(a, b).separate(a, b, motion, point);
            out.time = motion.time;
            out.approachSpeed = Math.max(0, -(motion.x * point.normalX + motion.y * point.normalY + motion.z * point.normalZ));
        }
    }
}
