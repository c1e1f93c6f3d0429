package starlogo.search
{
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Tests two rows of a table: whether they touch, when they touch, and how. RowPairs has an object of a subclass for each kind of pairs.
     *
     * @private
     */
    public class PairTests
    {
        /** Has only methods. */
        public function PairTests()
        {
        }

        /** See RowPairs.areTouching. */
        public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            return false;
        }

        /** See RowPairs.findTime. */
        public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
        }

        /** See RowPairs.findContact. */
        public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
        }

        /** See RowPairs.findImpact. */
        public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            findTime(table, a, b, motion);
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                findContact(table, a, b, motion, out);
            }
        }

        /** See RowPairs.findOuterContact. */
        public function findOuterContact(table:AgentTable, a:int, b:int, out:ContactPoint):void
        {
            RelativeMotion.NONE.time = 0;
            findContact(table, a, b, RelativeMotion.NONE, out);
        }

        /**
         * Finds the distance between two rows. RowPairs.isSecondFirst is false for the two.
         *
         * @param areTouching whether the two touch
         * @param out receives the distance and the closest points, in the world
         */
        public function findClosest(table:AgentTable, a:int, b:int, areTouching:Boolean, out:ClosestPair):void
        {
        }

        /** See RowPairs.hasExactContact. */
        public function hasExactContact(table:AgentTable, a:int, b:int):Boolean
        {
            return false;
        }
    }
}
