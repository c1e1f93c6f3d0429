package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * Tells whether and how two agents touch. <code>areColliding()</code> takes the two as they are now, <code>findContact()</code> as the last
     * search saw them, if it saw both. It changes no place and no motion of the search.
     *
     * @private
     */
    public final class AgentPairQuery
    {
        private var _table:AgentTable;
        private var _narrowPhase:NarrowPhase;
        private var _sweptTests:SweptTests;

        // The bodies of agents that have changed since the search.
        private var _bodyA:Body = new Body();
        private var _bodyB:Body = new Body();

        /**
         * @param table the agents of the last search
         * @param narrowPhase tests their bodies
         * @param sweptTests finds contacts on the motions of the last search
         */
        public function AgentPairQuery(table:AgentTable, narrowPhase:NarrowPhase, sweptTests:SweptTests)
        {
            _table = table;
            _narrowPhase = narrowPhase;
            _sweptTests = sweptTests;
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
            if (a.isOfWorld && b.isOfWorld)
            {
                throw new ArgumentError("the ground and the edges of the world have no contact with each other");
            }
            // they get the order that the pairs of a search have, so rounding is the same however a game asks
            if (_table.listed.orderKeyOf(a) > _table.listed.orderKeyOf(b))
            {
                findContactInOrder(b, a, motion, out);
                out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
                motion.endAfter(-motion.x, -motion.y, -motion.z);
                return;
            }
            findContactInOrder(a, b, motion, out);
        }

        // Finds the contact of an agent of the game with another agent, or with the ground or the edges of the world.
        private function findContactInOrder(a:Agent, b:Agent, motion:RelativeMotion, out:ContactPoint):void
        {
            var rowA:int = _table.listed.rowOf(a);
            var rowB:int = _table.listed.rowOf(b);
            var isSeenB:Boolean = _table.isSeen(rowB);
            var areSeen:Boolean = isSeenB && _table.isSeen(rowA);
            if (areSeen)
            {
                _table.followPose(rowA);
                _table.followPose(rowB);
                if (_sweptTests.isSwept)
                {
                    _sweptTests.findContact(rowA, rowB, motion, out);
                    return;
                }
            }
            var bodyA:Body = areSeen ? _table.bodyOf(rowA) : _table.currentBodyOf(a, _bodyA);
            var bodyB:Body = areSeen || isSeenB && b.isOfWorld ? _table.bodyOf(rowB) : _table.currentBodyOf(b, _bodyB);
            if (bodyA.shape == null || bodyB.shape == null)
            {
                var loading:Agent = bodyA.shape == null ? a : b;
                throw new ArgumentError(loading + ": its model is still loading");
            }
            _narrowPhase.pairTestsFor(bodyA, bodyB).findContact(bodyA, bodyB, motion, out);
        }
    }
}
