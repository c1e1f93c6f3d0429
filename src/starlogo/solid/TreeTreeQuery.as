package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.StructurePairs;

    use namespace engine;

    /**
     * Two placed trees. A traversal for each question visits pairs of nodes (thesis §4.6). It tests the boxes of leaves, or for exact tests their
     * triangles.
     *
     * @private
     */
    public final class TreeTreeQuery extends TreeQuery
    {
        // The two, and their nodes for a traversal.
        private var _a:ModelTree = null;
        private var _b:ModelTree = null;
        private var _trees:TreePair = new TreePair();

        // Test triangles.
        private var _pairKernel:TrianglePairKernel;
        private var _contactFinder:TriangleContactFinder;

        private var _overlap:OverlapTraversal;
        private var _impact:ImpactTraversal;
        private var _distance:DistanceTraversal;

        // The leaves or triangles of the two that touch first.
        private var _first:FirstImpact = new FirstImpact();

        // The pose of a in b's space, and a point of one of the two.
        private var _inverse:Placement = new Placement();
        private var _point:Vector3D = new Vector3D();

        /** @param counts counts what the questions take */
        public function TreeTreeQuery(counts:TreeCounts)
        {
            _trees.pose = pose;
            _pairKernel = new TrianglePairKernel(counts);
            _contactFinder = new TriangleContactFinder();
            _overlap = new OverlapTraversal(counts);
            _impact = new ImpactTraversal(counts);
            _distance = new DistanceTraversal(counts);
        }

        /**
         * Sets the two.
         *
         * @param depthA how many levels of a's tree are visited. If it and the other depth are BoxTree.EXACT, the triangles of both decide
         * @return this
         */
        public function setTo(a:ModelTree, placementA:Placement, depthA:int, b:ModelTree, placementB:Placement, depthB:int):TreeQuery
        {
            _a = a;
            _b = b;
            this.placementA = placementA;
            this.placementB = placementB;
            _trees.a = a.treeFor(depthA);
            _trees.b = b.treeFor(depthB);
            _trees.depthA = depthA;
            _trees.depthB = depthB;
            return this;
        }

        /** @inheritDoc */
        override internal function areTouchingInPose(still:RelativeMotion):Boolean
        {
            var result:int = _overlap.find(_trees, _pairKernel.begin(_trees, still));
            // If the roots do not overlap, neither model is inside of the other. This holds for most models that are close but do not collide.
            return result == OverlapTraversal.OVERLAPPING || result == OverlapTraversal.ONLY_ROOTS && findComponentInside(null);
        }

        /** @inheritDoc */
        override internal function findImpactInPose(motion:RelativeMotion, out:ContactPoint):void
        {
            _impact.findFirst(_trees, motion, _pairKernel.begin(_trees, motion), _first);
            if (out == null || motion.time == RelativeMotion.NEVER)
            {
                return;
            }
            if (_trees.isExact)
            {
                _contactFinder.find(_trees, _first.a, _first.b, motion, out);
            }
            else
            {
                findContactOfNodes(_first.a, _first.b, motion, out);
            }
        }

        /** @inheritDoc */
        override internal function findContactOfNodes(nodeA:int, nodeB:int, motion:RelativeMotion, out:ContactPoint):void
        {
            var placedB:BoundingStructure = pose.place(_trees.b.boxOf(nodeB));
            StructurePairs.findContact(placedB, _trees.a.boxOf(nodeA), motion, out);
        }

        /** @inheritDoc */
        override internal function findClosestOfSurfaces(out:ClosestPoints):void
        {
            _distance.findClosest(_trees, _pairKernel.begin(_trees, RelativeMotion.NONE), out);
        }

        /** Neither is inside if the boxes of the roots do not touch. Then the insides are not prepared. @inheritDoc */
        override internal function findInside(out:ClosestPoints):Boolean
        {
            var placedB:BoundingStructure = pose.placeWidened(_trees.b.boxOf(0));
            return StructurePairs.areTouching(_trees.a.boxOf(0), placedB) && findComponentInside(out);
        }

        // Does what findInside() does if the boxes of the roots touch.
        private function findComponentInside(out:ClosestPoints):Boolean
        {
            if (!_a.hasTriangles || !_b.hasTriangles)
            {
                return false;
            }
            Placement.invert(pose.placement, _inverse);
            return findComponentIn(_a, _b, pose.placement, placementA, out) || findComponentIn(_b, _a, _inverse, placementB, out);
        }

        // Finds a corner of a component of the inner model that is inside of the outer one. A component is connected. So if it does not touch the outer
        // surface, all of it is inside or outside, as this corner is. The pose is that of the inner model in the outer one's space, and the placement that
        // of the outer model. It is asked for all agents that are close but do not touch, so a ray is cast only if the corner is in the box around the outer
        // model.
        private function findComponentIn(outer:ModelTree, inner:ModelTree, pose:Placement, placement:Placement, out:ClosestPoints):Boolean
        {
            var tree:BoxTree = inner.boxTree;
            var points:Vector.<Number> = tree.vertices;
            var triangles:Vector.<int> = inner.preparedInterior().surface.componentTriangles;
            var count:int = outer.preparedInterior().hasClosedShell ? triangles.length : 0;
            for (var i:int = 0; i < count; i++)
            {
                var at:int = 3 * tree.triangles[3 * triangles[i]];
                _point.x = points[at];
                _point.y = points[int(at + 1)];
                _point.z = points[int(at + 2)];
                pose.place(_point, _point);
                if (outer.isInside(_point, 0))
                {
                    if (out != null)
                    {
                        out.setPoint(_point);
                        out.placePoints(placement);
                    }
                    return true;
                }
            }
            return false;
        }
    }
}
