package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxDistanceTraversal;
    import starlogo.hierarchy.BoxTraversal;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.NodePairTraversal;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.StructureLeaf;
    import starlogo.hierarchy.SweptBoxTraversal;
    import starlogo.hierarchy.UprightBoxTraversal;
    import starlogo.intersection.contact.ContactFinder;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.DistanceResult;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Tests two placed models: two trees, or a tree and a structure. <code>areOverlapping()</code> tests whether two standing models overlap.
     * For all other questions the pair is set once. Then it can be asked when the two first touch, where, and how far they are apart (thesis
     * §4.6). Nothing is allocated once the stacks have grown and the models' triangles are prepared.
     *
     * <p>The thesis transforms both structures into the world for each pair of nodes (§4.5). Here one RelativePose for each pair of models
     * transforms the second model into the first model's space. There a traversal of pairs of nodes decides, depth-first, down to two nodes
     * that are leaves or at their depth limit. A structure is a tree of one node. For exact tests, triangles decide about the leaves.</p>
     *
     * <p>The answers are nested. The leaves cover only the surface, so a ContainmentTest decides about a model inside a closed one.</p>
     *
     * @private
     */
    public final class TreePairQuery
    {
        // The pair. The second model is a tree, or a structure stands for it.
        private var _a:SolidHierarchy;
        private var _placementA:Placement;
        private var _depthA:int;
        private var _b:SolidHierarchy;
        private var _structureB:BoundingStructure;
        private var _placementB:Placement;
        private var _depthB:int;

        // When the two touch, if findFirst has found them.
        private var _time:Number = 0;

        // Whether triangles decide about leaves.
        private var _isExact:Boolean;

        // The first model's placement at the beginning. Transforms the second model into the first model's space.
        private var _start:Placement = new Placement();
        private var _pose:RelativePose = new RelativePose();

        private var _uprightBoxes:UprightBoxTraversal = new UprightBoxTraversal();
        private var _boxes:BoxTraversal = new BoxTraversal();
        private var _sweptBoxes:SweptBoxTraversal = new SweptBoxTraversal();
        private var _distances:BoxDistanceTraversal = new BoxDistanceTraversal();

        // The tests that decide about leaves.
        private var _leaf:StructureLeaf;
        private var _trianglePairs:LeafOverlapTest;
        private var _sweptPairs:LeafSweepTest;
        private var _nearest:LeafDistanceTest;
        private var _triangles:LeafStructureTest = new LeafStructureTest();
        private var _containment:ContainmentTest;

        // For contacts: nodes, and for each kind, a structure of the second model in the first model's space.
        private var _boxA:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        private var _boxB:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        private var _moved:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3, true);
        private var _finder:ContactFinder = new ContactFinder();

        public function TreePairQuery()
        {
            _leaf = new StructureLeaf(_pose.motion);
            _trianglePairs = new LeafOverlapTest(_pose);
            _sweptPairs = new LeafSweepTest(_pose);
            _nearest = new LeafDistanceTest(_pose);
            _containment = new ContainmentTest(_pose);
        }

        /** The number of pairs of nodes visited since resetCounts. */
        public function get nodeVisits():int
        {
            return _uprightBoxes.nodeVisits + _boxes.nodeVisits + _sweptBoxes.nodeVisits + _distances.nodeVisits + _triangles.boxes.nodeVisits;
        }

        /** The number of pairs of triangles, or of a triangle and a structure, tested since resetCounts. */
        public function get triangleTests():int
        {
            return _trianglePairs.triangleTests + _sweptPairs.triangleTests + _nearest.triangleTests + _triangles.triangleTests;
        }

        /** Sets all counts to 0. */
        public function resetCounts():void
        {
            _uprightBoxes.nodeVisits = _boxes.nodeVisits = _sweptBoxes.nodeVisits = _distances.nodeVisits = _triangles.boxes.nodeVisits = 0;
            _trianglePairs.triangleTests = _sweptPairs.triangleTests = _nearest.triangleTests = _triangles.triangleTests = 0;
        }

        /**
         * Sets the pair: two trees, or a tree and a structure.
         *
         * @param a the first model's hierarchy
         * @param placementA the first model's placement in the world
         * @param depthA how many levels of its hierarchy are visited
         * @param b the second model's hierarchy; null if a structure stands for that model
         * @param structureB that structure, in the second model's space; ignored if b is not null
         * @param placementB the second model's placement in the world
         * @param depthB how many levels of its hierarchy are visited
         * @param exact whether triangles decide in place of depths, if the trees have triangles. A tree and a structure collide if a triangle
         *     touches the solid structure, or if the structure is inside of the tree's closed surface
         */
        public function setTo(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, structureB:BoundingStructure,
                placementB:Placement, depthB:int, exact:Boolean):void
        {
            _isExact = exact && a.hasTriangles && (b == null || b.hasTriangles);
            // Writing an object to a field costs Adobe's VM more than comparing it first.
            if (_a !== a)
            {
                _a = a;
            }
            if (_b !== b)
            {
                _b = b;
            }
            if (_structureB !== structureB)
            {
                _structureB = structureB;
            }
            _placementA = placementA;
            _placementB = placementB;
            _depthA = _isExact ? int.MAX_VALUE : depthA;
            _depthB = _isExact ? int.MAX_VALUE : depthB;
            _pose.relate(placementA, placementB);
        }

        /**
         * Whether two standing models overlap. Afterwards, the pair must be set again for other questions.
         *
         * <p>The arguments are the same as for <code>setTo()</code>. They are not kept, because keeping them would take a tenth of the time
         * for two models that are apart.</p>
         */
        public function areOverlapping(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, structureB:BoundingStructure,
                placementB:Placement, depthB:int, exact:Boolean):Boolean
        {
            var pose:RelativePose = _pose;
            pose.relate(placementA, placementB);
            var decider:LeafTest = null;
            var traversal:NodePairTraversal = pose.isUpright ? _uprightBoxes : _boxes;
            if (exact && a.hasTriangles && b == null)
            {
                return findTriangle(a, structureB, RelativeMotion.NONE) || isOneInside(a, null, structureB);
            }
            if (exact && a.hasTriangles && b.hasTriangles)
            {
                decider = _trianglePairs.begin(a, b);
                depthA = depthB = int.MAX_VALUE;
            }
            var second:HierarchyNode;
            if (b != null)
            {
                second = b.root;
            }
            else
            {
                decider = prepareLeaf(structureB, RelativeMotion.NONE);
                traversal = _boxes;
                pose = _leaf.pose;
                second = _leaf.node;
            }
            // If the roots do not overlap, neither model is inside of the other. This holds for most models that are close but do not collide.
            return traversal.find(pose, a.root, depthA, second, depthB, decider)
                || ((traversal.rootsOverlapped || decider != null) && isOneInside(a, b, structureB));
        }

        /**
         * Finds the first moment at which the two overlap while the first one moves. Afterwards, the pair must be set again.
         *
         * <p>To get inside of a closed surface from outside, a part of a model has to cross it, and its nodes have to touch. So the nodes
         * or triangles are tested over time, and the standing test is made at time 0. If nothing is found, the standing test is made at
         * time 1 too, because rounding can miss a touch at the end of the motion.</p>
         *
         * @param motion of the first model, relative to the second; receives the time, from 0 to 1, or RelativeMotion.NEVER
         */
        public function findTime(motion:RelativeMotion):void
        {
            begin(motion);
            if (overlapsAt(_start))
            {
                motion.time = 0;
                return;
            }
            if (findFirst())
            {
                motion.time = _time;
                return;
            }
            _start.x += motion.x;
            _start.y += motion.y;
            _start.z += motion.z;
            motion.time = overlapsAt(_start) ? 1 : RelativeMotion.NEVER;
        }

        /**
         * Finds the contact of two models that collide. It is the contact of the first two triangles that touch, or of the first two nodes
         * that are leaves or at their depth limit. If one model is inside of the other, the structures around both have the contact.
         *
         * @param motion of the first model, relative to the second; its time is the time of impact
         * @param out receives the contact, in the world
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            begin(motion);
            if (findFirst() && _time <= motion.time + Tolerances.SAME_TIME)
            {
                findContactOfFirst(motion, out);
            }
            else
            {
                findContactOf(_a.root.writeBox(_boxA), _b == null ? _structureB : _b.root.writeBox(_boxB), motion, out);
            }
        }

        /**
         * Finds when and where the two first touch. They must not touch at the beginning.
         *
         * @param motion of the first model, relative to the second; receives the time, from 0 to 1, or RelativeMotion.NEVER
         * @param out receives the contact, in the world; null if only the time is needed
         */
        public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            begin(motion);
            motion.time = findFirst() ? _time : RelativeMotion.NEVER;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                findContactOfFirst(motion, out);
            }
        }

        /**
         * Finds the distance and the closest points of the two models as they were set. It measures the nodes that
         * <code>areOverlapping()</code> tests, or the triangles.
         *
         * @param areTouching whether the two overlap. If so, a point of both is found
         * @param out receives the distance and the points, in the world
         */
        public function findClosest(areTouching:Boolean, out:DistanceResult):void
        {
            _distances.structure = null;
            if (_b == null)
            {
                _leaf.begin(_structureB, _pose);
                _distances.structure = _leaf.moved;
            }
            search(_distances, _isExact ? beginDistance() : null);
            out.copyPoints(_distances.points);
            out.distance = _distances.least * _placementA.size;
            var placement:Placement = _placementA;
            // a point of both is known already if the measured distance is 0
            var needsPoint:Boolean = areTouching && out.distance > 0;
            if (needsPoint && isOneInside(_a, _b, _structureB))
            {
                var point:Vector3D = _containment.innerPoint;
                out.aX = out.bX = point.x;
                out.aY = out.bY = point.y;
                out.aZ = out.bZ = point.z;
                placement = _containment.isPointOfSecond ? _placementB : _placementA;
            }
            else if (needsPoint && _isExact && _b == null)
            {
                // No triangle crosses the surface of the box. So the box is around the triangles that touch it.
                findTriangle(_a, _structureB, RelativeMotion.NONE);
                _triangles.takeCorner(_leaf.moved, out);
            }
            out.settle(areTouching);
            out.place(placement);
        }

        /**
         * Finds the contact of the structures around two standing models. Afterwards, the pair must be set again.
         *
         * @param a the structure around the first model, in its space
         * @param placementA the first model's placement in the world
         * @param b the structure around the second model, in its space
         * @param placementB the second model's placement in the world
         * @param out receives the contact, in the world
         */
        public function findOuterContact(a:BoundingStructure, placementA:Placement, b:BoundingStructure, placementB:Placement,
                out:ContactPoint):void
        {
            _placementA = placementA;
            _placementB = placementB;
            begin(RelativeMotion.NONE);
            findContactOf(a, b, RelativeMotion.NONE, out);
        }

        private function overlapsAt(placementA:Placement):Boolean
        {
            return areOverlapping(_a, placementA, _depthA, _b, _structureB, _placementB, _depthB, _isExact);
        }

        private function begin(motion:RelativeMotion):void
        {
            _start.copyFrom(_placementA);
            _start.x += motion.startX;
            _start.y += motion.startY;
            _start.z += motion.startZ;
            _pose.relate(_start, _placementB);
            _pose.relateMotion(_placementA, motion);
        }

        // Returns the test of a structure and the leaves of the first model, or null if the structure's box decides.
        private function prepareLeaf(structureB:BoundingStructure, motion:RelativeMotion):LeafTest
        {
            _leaf.begin(structureB, _pose);
            if (structureB.kind == BoundingStructure.BOX)
            {
                return null;
            }
            if (_leaf.motion !== motion)
            {
                _leaf.motion = motion;
            }
            return _leaf;
        }

        private function beginDistance():LeafTest
        {
            if (_b == null)
            {
                _triangles.beginDistance(_a, _structureB, _pose);
                return _triangles;
            }
            return _nearest.begin(_a, _b);
        }

        private function search(traversal:NodePairTraversal, decider:LeafTest):Boolean
        {
            return _b == null ? traversal.find(_leaf.pose, _a.root, _depthA, _leaf.node, 1, decider)
                : traversal.find(_pose, _a.root, _depthA, _b.root, _depthB, decider);
        }

        private function isOneInside(a:SolidHierarchy, b:SolidHierarchy, structureB:BoundingStructure):Boolean
        {
            return b == null ? _containment.isStructureInside(a, moveToFirst(structureB)) : _containment.isOneInside(a, b);
        }

        // Finds the first triangle of a model that touches a structure in the place of the second model.
        private function findTriangle(a:SolidHierarchy, structureB:BoundingStructure, motion:RelativeMotion):Boolean
        {
            _triangles.begin(a, structureB, _pose, motion);
            if (_triangles.isCompact)
            {
                return _triangles.find();
            }
            _leaf.begin(structureB, _pose);
            var traversal:NodePairTraversal = motion === RelativeMotion.NONE ? _boxes : _sweptBoxes;
            return traversal.find(_leaf.pose, a.root, int.MAX_VALUE, _leaf.node, 1, _triangles);
        }

        // Finds the first two triangles or nodes that touch while the first model moves, and the time.
        private function findFirst():Boolean
        {
            var isFound:Boolean;
            if (_isExact && _b == null)
            {
                isFound = findTriangle(_a, _structureB, _pose.motion);
                _time = _triangles.least;
                return isFound;
            }
            var decider:LeafTest = _isExact ? _sweptPairs.begin(_a, _b) : (_b == null ? prepareLeaf(_structureB, _pose.motion) : null);
            isFound = search(_sweptBoxes, decider);
            _time = _sweptBoxes.least;
            return isFound;
        }

        // The contact of the two that findFirst has found, at the motion's time.
        private function findContactOfFirst(motion:RelativeMotion, out:ContactPoint):void
        {
            if (!_isExact)
            {
                findContactOf(_sweptBoxes.firstA.writeBox(_boxA), _b == null ? _structureB : _sweptBoxes.firstB.writeBox(_boxB), motion, out);
                return;
            }
            var decider:LeafTest = _b == null ? _triangles : _sweptPairs;
            _pose.motion.time = motion.time;
            decider.findContact(out);
            moveToWorld(motion, out);
        }

        // The contact of two structures in their models' spaces, at the motion's time.
        private function findContactOf(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            var time:Number = motion.time;
            var way:RelativeMotion = _pose.motion;
            var displacement:RelativeMotion = _finder.displacement;
            displacement.startX = -time * way.x;
            displacement.startY = -time * way.y;
            displacement.startZ = -time * way.z;
            _finder.find(a, moveToFirst(b), out);
            out.x += time * way.x;
            out.y += time * way.y;
            out.z += time * way.z;
            moveToWorld(motion, out);
        }

        private function moveToFirst(structure:BoundingStructure):BoundingStructure
        {
            return _moved[structure.kind] = structure.place(_pose.placement, _moved[structure.kind]);
        }

        private function moveToWorld(motion:RelativeMotion, out:ContactPoint):void
        {
            var a:Placement = _placementA;
            var time:Number = motion.time;
            var x:Number = out.x * a.size;
            var y:Number = out.y * a.size;
            var z:Number = out.z * a.size;
            out.x = a.r00 * x + a.r01 * y + a.r02 * z + a.x + motion.startX + time * motion.x;
            out.y = a.r10 * x + a.r11 * y + a.r12 * z + a.y + motion.startY + time * motion.y;
            out.z = a.r20 * x + a.r21 * y + a.r22 * z + a.z + motion.startZ + time * motion.z;
            x = out.normalX;
            y = out.normalY;
            z = out.normalZ;
            out.normalX = a.r00 * x + a.r01 * y + a.r02 * z;
            out.normalY = a.r10 * x + a.r11 * y + a.r12 * z;
            out.normalZ = a.r20 * x + a.r21 * y + a.r22 * z;
            out.depth *= a.size;
        }
    }
}
