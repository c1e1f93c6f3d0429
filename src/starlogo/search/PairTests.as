package starlogo.search
{
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Tests two rows of a table: whether they touch, when they touch, and how. RowPairs has an object of a subclass for each kind of pairs.
     * The ground or the edges of the world are always the second of two rows.
     *
     * @private
     */
    public class PairTests
    {
        /** The length that any way out of the last contact has at least; 0 if it is not known. */
        public var needed:Number = 0;

        /** How far away parts of the second row count in <code>findWays()</code>. */
        public var reach:Number = 0;

        /** Has only methods. */
        public function PairTests()
        {
        }

        /** Whether two rows touch. */
        public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            return false;
        }

        /**
         * Keeps the members that touch a row, and moves them to the beginning of the list.
         *
         * @param rows the row of each member
         * @param members the list of members
         * @param count its length
         * @return the number of members that it keeps
         */
        public function keepMembers(table:AgentTable, rows:Vector.<int>, members:Vector.<int>, count:int, b:int):int
        {
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                if (areTouching(table, rows[members[i]], b))
                {
                    members[kept] = members[i];
                    kept++;
                }
            }
            return kept;
        }

        /**
         * Finds the time at which two rows first touch, while the first one moves. It is the first moment at which <code>areTouching()</code>
         * would be true.
         *
         * @param motion the motion of the first row relative to the second. It ends where the first row is now. It receives the time, from 0 to
         *     1, or RelativeMotion.NEVER
         */
        public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
        }

        /**
         * Finds the contact of two rows.
         *
         * @param motion as in findTime, with the time of the first touch
         * @param out receives the contact. Its normal points from b to a, and b is where it is now
         */
        public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
        }

        /**
         * Finds the time and the contact of the first touch of two rows. They must not touch at the beginning of the motion.
         *
         * @param motion as in findTime. But a touch that rounding errors hide at its end may be missing
         * @param out receives the contact, as in findContact; null if only the time is needed
         */
        public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            findTime(table, a, b, motion);
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                findContact(table, a, b, motion, out);
            }
        }

        /**
         * Finds the contact of the structures around two rows, where they are.
         *
         * @param out receives the contact. Its normal points from b to a
         */
        public function findOuterContact(table:AgentTable, a:int, b:int, out:ContactPoint):void
        {
            findContact(table, a, b, RelativeMotion.NONE, out);
        }

        /**
         * Finds contacts with which other ways out of the second row may begin, within <code>reach</code>.
         *
         * @param ways receives the contacts, each with another direction
         * @return their number
         */
        public function findWays(table:AgentTable, a:int, b:int, ways:Vector.<ContactPoint>):int
        {
            return 0;
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

        /**
         * Whether the contact of two rows is exact: if the first row moves by its depth, the two just touch. Other contacts belong to parts of
         * the two rows, and other parts may still overlap.
         */
        public function hasExactContact(table:AgentTable, a:int, b:int):Boolean
        {
            return false;
        }
    }
}
