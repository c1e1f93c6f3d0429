package starlogo.search.penetration
{
    import starlogo.convex.ContactPoint;
    import starlogo.search.Body;

    /**
     * What an ExitSearch knows about the lengths of the ways out of two bodies: a way that leads out, and a length that all ways have. Tests of pairs
     * whose contacts need a search implement it.
     *
     * @private
     */
    public interface ExitBounds
    {
        /** Finds the contact of convex covers of two bodies, where they are. The way out of the covers leads out of the bodies too. */
        function findContactOfCovers(a:Body, b:Body, out:ContactPoint):void;

        /** Whether a contact's deepest point is known to be inside of a body. */
        function isDeepestInside(b:Body, contact:ContactPoint):Boolean;

        /**
         * A lower bound for the lengths of the exits of a contact's deepest point from a body; 0 if none is known. Exits that are longer than
         * <code>maxLength</code> do not count. If this point is known to be of the first body (<code>isDeepestOfA</code>), it has to get out.
         */
        function exitBoundOf(b:Body, contact:ContactPoint, maxLength:Number):Number;
    }
}
