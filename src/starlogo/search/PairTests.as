package starlogo.search
{
    import flash.errors.IllegalOperationError;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;

    /**
     * Tests two bodies: whether they touch, when they touch, and how. NarrowPhase has an object of a subclass for each kind of pairs. The ground or
     * the edges of the world are always the second of two bodies.
     *
     * @private
     */
    public class PairTests
    {
        /** Whether two bodies touch. The answer must be the same in either order, to the last bit. */
        public function areTouching(a:Body, b:Body):Boolean
        {
            throw new IllegalOperationError(this + " does not implement areTouching");
        }

        /**
         * Keeps the rows of a list that touch a body, and moves them to the beginning of the list.
         *
         * @param rows the list
         * @param count its length
         * @return the number of rows that it keeps
         */
        public function keepRows(table:AgentTable, rows:Vector.<int>, count:int, b:Body):int
        {
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                if (areTouching(table.bodyOf(rows[i]), b))
                {
                    rows[kept] = rows[i];
                    kept++;
                }
            }
            return kept;
        }

        /**
         * Finds the time at which two bodies first touch, while the first one moves. It is the first moment at which <code>areTouching()</code>
         * would be true.
         *
         * @param motion the motion of the first body relative to the second. It ends where the first body is now. It receives the time, from 0 to
         *     1, or RelativeMotion.NEVER
         */
        public function findTime(a:Body, b:Body, motion:RelativeMotion):void
        {
            throw new IllegalOperationError(this + " does not implement findTime");
        }

        /**
         * Finds the time at which two bodies first touch, as <code>findTime()</code> does, and their contact then.
         *
         * @param out receives the contact if they touch, as in findContact; null if only the time is needed
         */
        public function findFirst(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            findTime(a, b, motion);
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                findContact(a, b, motion, out);
            }
        }

        /**
         * Finds the contact of two bodies.
         *
         * @param motion as in findTime, with the time of the first touch
         * @param out receives the contact. Its normal points from b to a, and b is where it is now
         */
        public function findContact(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement findContact");
        }

        /**
         * Finds the time and the contact of the first touch of two bodies. They must not touch at the beginning of the motion.
         *
         * @param motion as in findTime. But a touch that rounding errors hide at its end may be missing
         * @param out receives the contact, as in findContact; null if only the time is needed
         */
        public function findImpact(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            findFirst(a, b, motion, out);
        }

        /**
         * Finds the contact of the structures around two bodies, where they are.
         *
         * @param out receives the contact. Its normal points from b to a
         */
        public function findOuterContact(a:Body, b:Body, out:ContactPoint):void
        {
            findContact(a, b, RelativeMotion.NONE, out);
        }

        /**
         * Finds contacts with which other ways out of the second body may begin. The last contact that was found must be of the same two bodies.
         *
         * @param maxDistance parts of the second body farther away do not count
         * @param exits receives the contacts, each with another direction
         * @return their number
         */
        public function findExits(a:Body, b:Body, maxDistance:Number, exits:Vector.<ContactPoint>):int
        {
            return 0;
        }

        /** Whether a ray meets a body. If it does, the ray begins there, and has the normal. Only the ground answers. */
        public function isMet(b:Body, ray:Ray):Boolean
        {
            return false;
        }

        /** Adds all crossings of a ray with the surface of a body. Only the ground answers. */
        public function findCrossings(b:Body, ray:Ray, out:RayCrossings):void
        {
        }

        /** Whether a piece of the first body is deeper in the second than this, in patches. Only the ground answers. */
        public function isDeeper(a:Body, b:Body, depth:Number):Boolean
        {
            return false;
        }

        /**
         * Finds the distance between two bodies. NarrowPhase.isSecondFirst is false for the two.
         *
         * @param areTouching whether the two touch
         * @param out receives the distance and the closest points, in the world
         */
        public function findClosest(a:Body, b:Body, areTouching:Boolean, out:ClosestPoints):void
        {
            throw new IllegalOperationError(this + " does not implement findClosest");
        }

        /**
         * Changes a contact's normal and depth so that they separate two bodies: if the first one moves along the normal by the depth, the two just
         * touch. Most contacts do this already, and only the point moves, to the middle of the overlap.
         *
         * @param motion as in findTime, with the time at which the two touch
         * @param out the contact of two parts that touch at that time
         */
        public function separate(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            OverlapMiddle.setAlong(a, b, out);
        }
    }
}
