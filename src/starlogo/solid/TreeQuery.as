package starlogo.solid
{
    import flash.errors.IllegalOperationError;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * Two placed models a and b, of which a is a tree: whether they overlap, how far they are apart, and when and where they touch while a moves. Abstract:
     * b is a tree too (TreeTreeQuery), or a structure stands for it (TreeStructureQuery). Nothing is allocated once the stacks have grown and the models'
     * triangles are prepared.
     *
     * <p>The thesis transforms both structures into the world for each pair of nodes (§4.5). Here one RelativePose for each pair of models transforms
     * b into a's space, where all is decided.</p>
     *
     * <p>A smaller depth finds all that a greater depth or the triangles find: no farther away, and no later but for rounding. Nodes and triangles cover
     * only the surface. So if the surfaces do not touch, <code>findInside()</code> decides.</p>
     *
     * @private
     */
    public class TreeQuery extends ImpactQuery
    {
        /** The placement of a in the world. */
        public var placementA:Placement = null;

        /** The placement of b in the world. */
        public var placementB:Placement = null;

        /** The pose of b in a's space. */
        public var pose:RelativePose = new RelativePose();

        // The motion of b in a's space, from the pose on. Its length is 0 if b stands.
        private var _motion:RelativeMotion = new RelativeMotion();

        /** Whether the two touch where they stand: their surfaces do, or one of them is inside of the other. */
        public final function areTouching():Boolean
        {
            return areTouchingAt(RelativeMotion.NONE, 0);
        }

        /** @inheritDoc */
        override public final function areTouchingAt(motion:RelativeMotion, time:Number):Boolean
        {
            pose.setBetween(placementA, placementB, motion, time);
            _motion.copyVector(RelativeMotion.NONE);
            _motion.latestTime = 1;
            return areTouchingInPose(_motion);
        }

        /** @inheritDoc */
        override public final function findImpactOfSurfaces(motion:RelativeMotion, out:ContactPoint):void
        {
            pose.setBetween(placementA, placementB, motion, 0);
            RelativePose.writeMotion(placementA, motion, _motion);
            findImpactInPose(_motion, out);
            motion.time = _motion.time;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                RelativePose.moveContactToWorld(out, placementA, motion);
            }
        }

        /**
         * Does what findImpactOfSurfaces() does, but if one of the two is inside of the other where the motion begins, the time is 0, and the contact's
         * normal 0.
         *
         * @param out must not be null
         */
        public final function findImpactOfSolids(motion:RelativeMotion, out:ContactPoint):void
        {
            findImpactOfSurfaces(motion, out);
            // the pose is still that of the beginning
            if (motion.time > 0 && findInside(null))
            {
                motion.time = 0;
                out.setNormal(0, 0, 0);
            }
        }

        /**
         * It is the contact of two triangles that touch there, or of two leaves. If one model is inside of the other, it is the contact of
         * the boxes of their roots.
         *
         * @inheritDoc
         */
        override public final function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            pose.setBetween(placementA, placementB, motion, motion.time);
            RelativePose.writeMotion(placementA, motion, _motion);
            // Only what touches at once counts. The motion turns the contact to a plane that it comes against.
            _motion.latestTime = 0;
            findImpactInPose(_motion, out);
            if (_motion.time == RelativeMotion.NEVER)
            {
                _motion.time = 0;
                findContactOfNodes(0, 0, _motion, out);
            }
            RelativePose.moveContactToWorld(out, placementA, motion);
        }

        /**
         * Finds the distance and the closest points of the two where they stand.
         *
         * @param areTouching whether the two touch. If so, a point of both is found
         * @param out receives the distance and the points, in the world
         */
        public final function findClosest(areTouching:Boolean, out:ClosestPoints):void
        {
            pose.setBetween(placementA, placementB, RelativeMotion.NONE, 0);
            findClosestOfSurfaces(out);
            out.distance *= placementA.size;
            // a point of both is known already if the measured distance is 0
            var isPointNeeded:Boolean = areTouching && out.distance > 0;
            if (!isPointNeeded || !findInside(out))
            {
                out.correct(areTouching);
                out.placePoints(placementA);
            }
        }

        /** Whether the two touch in their pose. The motion has length 0; a search may overwrite its times. */
        internal function areTouchingInPose(still:RelativeMotion):Boolean
        {
            throw new IllegalOperationError(this + " does not implement areTouchingInPose");
        }

        /**
         * Finds when the surfaces of the two first touch.
         *
         * @param motion of b in a's space, from the pose on; receives the time, and its latest time is overwritten
         * @param out receives the contact then, in a's space, with a normal from a to b, and the number of a's triangle if b is a structure; null if
         *     only the time is needed
         */
        internal function findImpactInPose(motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement findImpactInPose");
        }

        /**
         * Finds the contact of a node of a with a node of b, 0 for its root, or with the structure. The other parameters are those of
         * <code>findImpactInPose()</code>.
         */
        internal function findContactOfNodes(nodeA:int, nodeB:int, motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement findContactOfNodes");
        }

        /** Finds the distance and the closest points of the surfaces in their pose. The argument receives them, in a's space. */
        internal function findClosestOfSurfaces(out:ClosestPoints):void
        {
            throw new IllegalOperationError(this + " does not implement findClosestOfSurfaces");
        }

        /**
         * Finds a point of one of the two that is inside of the other. A search has found before that their surfaces do not touch in their pose.
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
