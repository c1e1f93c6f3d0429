package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.search.pairs.PairTests;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * Tells whether and how two agents touch. <code>areColliding()</code> takes the two as they are now, <code>findContact()</code> as the last search saw
     * them, if it saw both.
     *
     * @private
     */
    public final class AgentContacts
    {
        private var _table:AgentTable;
        private var _narrowPhase:NarrowPhase;
        private var _motions:RowMotions;

        // The bodies of agents that have changed since the search.
        private var _bodyA:Body = new Body();
        private var _bodyB:Body = new Body();

        /**
         * @param table has the rows of the last search
         * @param narrowPhase tests their bodies
         * @param motions those of the rows
         */
        public function AgentContacts(table:AgentTable, narrowPhase:NarrowPhase, motions:RowMotions)
        {
            _table = table;
            _narrowPhase = narrowPhase;
            _motions = motions;
        }

        /** Whether two agents touch where they are now. See CollisionSystem.areColliding. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            var bodyA:Body = _table.currentBodyOf(a, _bodyA);
            var bodyB:Body = _table.currentBodyOf(b, _bodyB);
            return bodyA.shape != null && bodyB.shape != null && _narrowPhase.areTouching(bodyA, bodyB);
        }

        /**
         * Finds the contact of two agents that touch. It takes them where the last search saw them, or where they are now if the last search did
         * not see both. The ground and the edges of the world count as the table has read them.
         *
         * @param motion receives the motion of the first relative to the second, with the time of the touch: 1 if neither sweeps
         * @param out receives the contact. Its normal points from the second agent to the first
         * @throws ArgumentError if a model is unknown or still loading, or if both stand for the ground or the edges of the world
         */
        public function findContact(a:Agent, b:Agent, motion:RelativeMotion, out:ContactPoint):void
        {
            if (a.isEnvironment && b.isEnvironment)
            {
                throw new ArgumentError("the ground and the edges of the world have no contact with each other");
            }
            var rowA:int = _table.listed.rowOf(a);
            var rowB:int = _table.listed.rowOf(b);
            if (_table.listed.orderKeyOf(a, rowA) > _table.listed.orderKeyOf(b, rowB))
            {
                // they get the order that the pairs of a search have, so rounding is the same however a game asks
                findContact(b, a, motion, out);
                out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
                motion.endAfter(-motion.x, -motion.y, -motion.z);
                return;
            }
            // from here on the first is an agent of the game
            var areSeen:Boolean = _table.isSeen(rowA) && _table.isSeen(rowB);
            if (areSeen)
            {
                _table.followPose(rowA);
                _table.followPose(rowB);
                if (findContactOnMotions(rowA, rowB, motion, out))
                {
                    return;
                }
            }
            var bodyA:Body = areSeen ? _table.bodyOf(rowA) : _table.currentBodyOf(a, _bodyA);
            var bodyB:Body = areSeen || b.isEnvironment && _table.isSeen(rowB) ? _table.bodyOf(rowB) : _table.currentBodyOf(b, _bodyB);
            if (bodyA.shape == null || bodyB.shape == null)
            {
                var loading:Agent = bodyA.shape == null ? a : b;
                throw new ArgumentError(loading + ": its model is still loading");
            }
            _narrowPhase.pairTestsFor(bodyA, bodyB).findContact(bodyA, bodyB, motion, out);
        }

        // Finds the contact of two rows if one of them sweeps and they touch on their motions. The second may be the ground or the edges. The motion receives
        // the time, and the contact separates them at that time. Returns whether one sweeps and they touch.
        private function findContactOnMotions(a:int, b:int, motion:RelativeMotion, out:ContactPoint):Boolean
        {
            if (!_motions.anySweeps || !_motions.eitherSweeps(a, b))
            {
                return false;
            }
            var bodyA:Body = _table.bodyOf(a);
            var bodyB:Body = _table.bodyOf(b);
            var tests:PairTests = _narrowPhase.pairTestsFor(bodyA, bodyB);
            _motions.setRelativeMotion(a, b, motion);
            if (!motion.isStill)
            {
                tests.findFirstTouch(bodyA, bodyB, motion, out);
            }
            else if (tests.areTouching(bodyA, bodyB))
            {
                motion.time = _motions.timeOfCommonMotion(a);
                tests.findContactOfParts(bodyA, bodyB, motion, out);
            }
            if (motion.time == RelativeMotion.NEVER)
            {
                return false;
            }
            tests.separate(bodyA, bodyB, motion, out);
            // the motion was relative to b at its present place, so the point is moved back to where b was at that time
            var back:Number = motion.time - 1;
            out.x += back * _motions.displacements.x[b];
            out.y += back * _motions.displacements.y[b];
            out.z += back * _motions.displacements.z[b];
            return true;
        }
    }
}
