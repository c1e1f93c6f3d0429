package starlogo.solid
{
    import flash.errors.IllegalOperationError;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.RelativePose;

    use namespace engine;

    /**
     * Two placed models a and b, of which a is a tree: whether they overlap, how far they are apart, and when their surfaces first touch. Abstract: b is
     * a tree too (TreeTreePair), or a structure stands for it (TreeStructurePair). Nothing is allocated once the stacks have grown and the models'
     * triangles are prepared.
     *
     * <p>The thesis transforms both structures into the world for each pair of nodes (§4.5). Here one RelativePose for each pair of models transforms
     * b into a's space, where all is decided.</p>
     *
     * <p>The answers are nested. Nodes and triangles cover only the surface. So if the surfaces do not touch, <code>findInside()</code> decides.</p>
     *
     * @private
     */
    public class TreePair
    {
        /** The placement of a in the world. */
        public var placementA:Placement = null;

        /** The placement of b in the world. */
        public var placementB:Placement = null;

        /** The pose of b in a's space. */
        public var pose:RelativePose = new RelativePose();

        /** Whether the two touch where they stand: their surfaces do, or one of them is inside of the other. */
        public final function areTouching():Boolean
        {
            relate();
            return areTouchingInPose();
        }

        /**
         * Finds the distance and the closest points of the two where they stand.
         *
         * @param doTouch whether the two touch. If so, a point of both is found
         * @param out receives the distance and the points, in the world
         */
        public final function findClosest(doTouch:Boolean, out:ClosestPoints):void
        {
            relate();
            findClosestOfSurfaces(out);
            out.distance *= placementA.size;
            // a point of both is known already if the measured distance is 0
            var isPointNeeded:Boolean = doTouch && out.distance > 0;
            if (!isPointNeeded || !findInside(out))
            {
                out.correct(doTouch);
                out.placePoints(placementA);
            }
        }

        /** Sets the pose to that where both models stand. */
        internal final function relate():void
        {
            pose.relate(placementA, placementB);
        }

        /** Sets the pose to that where a motion has brought a at a time. */
        internal final function relateAt(motion:RelativeMotion, time:Number):void
        {
            pose.relateAt(placementA, motion, time, placementB);
        }

        /** Whether the two touch in their pose. */
        internal function areTouchingInPose():Boolean
        {
            throw new IllegalOperationError(this + " does not implement areTouchingInPose");
        }

        /**
         * Finds when the surfaces of the two first touch.
         *
         * @param motion of b in a's space, from the pose on; receives the time
         * @param out receives the contact then, in a's space, with a normal from a to b, and the number of a's triangle if b is a structure; null if
         *     only the time is needed
         */
        internal function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement findImpact");
        }

        /**
         * Finds the contact of a's root with b's root, or with the structure. The parameters are those of <code>findImpact()</code>.
         */
        internal function findContactOfRoots(motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement findContactOfRoots");
        }

        /** Finds the distance and the closest points of the surfaces in their pose. The argument receives them, in a's space. */
        internal function findClosestOfSurfaces(out:ClosestPoints):void
        {
            throw new IllegalOperationError(this + " does not implement findClosestOfSurfaces");
        }

        /**
         * Finds a point of one of the two, whose surfaces do not touch in their pose, that is inside of the other.
         *
         * @param out receives the point twice, in the world, if there is one; null if only the answer is needed
         * @return whether there is one
         */
        internal function findInside(out:ClosestPoints):Boolean
        {
            throw new IllegalOperationError(this + " does not implement findInside");
        }
    }
}
