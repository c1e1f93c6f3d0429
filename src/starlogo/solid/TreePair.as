package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxDistances;
    import starlogo.hierarchy.BoxTraversal;
    import starlogo.hierarchy.DistanceTraversal;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.NodePairTraversal;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.StructureTraversal;
    import starlogo.hierarchy.SweptBoxTraversal;
    import starlogo.hierarchy.UprightBoxTraversal;
    import starlogo.intersection.contact.ContactFinder;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Tests two placed models: two trees, or a tree and a structure. <code>areOverlapping()</code> tests whether two standing models overlap.
     * For all other questions the pair is set once. Then it can be asked when the two first touch, where, and how far they are apart (thesis
     * §4.6). Nothing is allocated once the stacks have grown and the models' triangles are prepared.
     *
     * <p>The thesis transforms both structures into the world for each pair of nodes (§4.5). Here one RelativePose for each pair of models
     * transforms the second model into the first model's space. There a traversal of pairs of nodes decides, depth-first, down to two nodes
     * that are leaves or at their depth limit. The nodes' structures, boxes or others, decide which traversal it is. For exact tests,
     * triangles decide about the leaves.</p>
     *
     * <p>The answers are nested. The leaves cover only the surface, so a ContainmentTest decides about a model inside a closed one.</p>
     *
     * @private
     */
    public final class TreePair
    {
        // The pair. The second model is a tree, or a structure stands for it.
        private var _a:SolidHierarchy;
        private var _placementA:Placement;
        private var _depthA:int;
        private var _b:SolidHierarchy;
        private var _placementB:Placement;
        private var _depthB:int;

        // Whether triangles decide about leaves, and whether the nodes visited are boxes.
        private var _isExact:Boolean;

        // A node that stands for a structure.
        private var _leaf:HierarchyNode = new HierarchyNode();

        // Transforms the second model into the first model's space. For a box, also the space of its axes, and the node that stands for it.
        private var _pose:RelativePose = new RelativePose();
        private var _boxPose:RelativePose = new RelativePose();
        private var _boxLeaf:HierarchyNode = new HierarchyNode();
        private var _movedBox:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        // for standing models
        private var _uprightBoxes:UprightBoxTraversal;
        private var _boxes:BoxTraversal;
        private var _boxAndBoxes:BoxTraversal;
        private var _structures:StructureTraversal;
        private var _trianglePairs:ExactPairTest;
        private var _triangles:StructureTriangles = new StructureTriangles();
        private var _containment:ContainmentTest;

        // for moving models; the traversal that found the first touch
        private var _sweptBoxes:SweptBoxTraversal;
        private var _sweptStructures:StructureTraversal;
        private var _sweptPairs:SweptPairTest;
        private var _first:NodePairTraversal;
        private var _decider:LeafTest;

        // for distances
        private var _boxDistances:BoxDistances;
        private var _structureDistances:DistanceTraversal;
        private var _nearest:NearestTriangles;

        // The first model's placement at the current time. For each kind, a structure of the second model in the first model's space.
        private var _start:Placement = new Placement();
        private var _moved:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3, true);
        private var _finder:ContactFinder = new ContactFinder();

        /** Creates a test without a pair. All counts are 0. */
        public function TreePair()
        {
            _leaf.x = _leaf.y = _leaf.z = _boxLeaf.x = _boxLeaf.y = _boxLeaf.z = 0;
            _leaf.setHalfExtents(0, 0, 0);
            _leaf.end = 1;
            _uprightBoxes = new UprightBoxTraversal(_pose);
            _boxes = new BoxTraversal(_pose);
            _boxAndBoxes = new BoxTraversal(_boxPose);
            _structures = new StructureTraversal(_pose, false);
            _trianglePairs = new ExactPairTest(_pose);
            _containment = new ContainmentTest(_pose);
            _sweptBoxes = new SweptBoxTraversal(_pose);
            _sweptStructures = new StructureTraversal(_pose, true);
            _sweptPairs = new SweptPairTest(_pose);
            _boxDistances = new BoxDistances(_pose);
            _structureDistances = new DistanceTraversal(_pose);
            _nearest = new NearestTriangles(_pose);
        }

        /** The number of pairs of nodes visited since resetCounts. */
        public function get nodeVisits():int
        {
            return _uprightBoxes.nodeVisits + _boxes.nodeVisits + _boxAndBoxes.nodeVisits + _structures.nodeVisits + _sweptBoxes.nodeVisits
                + _sweptStructures.nodeVisits + _boxDistances.nodeVisits + _structureDistances.nodeVisits;
        }

        /** The number of pairs of triangles tested since resetCounts. */
        public function get triangleTests():int
        {
            return _trianglePairs.triangleTests + _sweptPairs.triangleTests + _nearest.triangleTests;
        }

        /** Sets all counts to 0. */
        public function resetCounts():void
        {
            _uprightBoxes.nodeVisits = _boxes.nodeVisits = _boxAndBoxes.nodeVisits = _structures.nodeVisits = _sweptBoxes.nodeVisits = 0;
            _sweptStructures.nodeVisits = _boxDistances.nodeVisits = _structureDistances.nodeVisits = 0;
            _trianglePairs.triangleTests = _sweptPairs.triangleTests = _nearest.triangleTests = 0;
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
         * @param exact whether triangles decide in place of depths, if both are trees with triangles; must be false for a tree and a
         *     structure
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
            if (b == null && _leaf.structure !== structureB)
            {
                _leaf.structure = structureB;
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
         * <p>The arguments are the same as for <code>setTo()</code>. In addition, triangles may decide for a tree and a structure: the two
         * collide if a triangle touches the solid structure. The arguments are not kept, because keeping them would take a tenth of the
         * time for two models that are apart.</p>
         */
        public function areOverlapping(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, structureB:BoundingStructure,
                placementB:Placement, depthB:int, exact:Boolean):Boolean
        {
            var pose:RelativePose = _pose;
            pose.relate(placementA, placementB);
            var decider:LeafTest = null;
            if (exact && a.hasTriangles && (b == null || b.hasTriangles))
            {
                decider = prepareTriangles(a, b, structureB);
                depthA = depthB = int.MAX_VALUE;
            }
            var traversal:NodePairTraversal = _structures;
            var second:HierarchyNode = _leaf;
            if (b != null)
            {
                second = b.root;
                traversal = pose.isUpright ? _uprightBoxes : _boxes;
            }
            else if (structureB.kind == BoundingStructure.BOX)
            {
                traversal = _boxAndBoxes;
                second = _boxLeaf;
                setBoxLeaf(Box(structureB));
            }
            else if (_leaf.structure !== structureB)
            {
                _leaf.structure = structureB;
            }
            // Most models that are close but do not collide have roots that do not overlap. These are not inside of each other.
            return traversal.find(a.root, depthA, second, depthB, decider)
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
                motion.time = _first.time;
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
            if (findFirst() && _first.time <= motion.time + Tolerances.SAME_TIME)
            {
                findContactOfFirst(motion, out);
            }
            else
            {
                findContactOf(_a.root.bounds, rootB.bounds, motion, out);
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
            motion.time = findFirst() ? _first.time : RelativeMotion.NEVER;
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
        public function findClosest(areTouching:Boolean, out:ClosestPair):void
        {
            _leaf.radius = _b == null ? DistanceTraversal.reachOf(_leaf.structure) : 0;
            if (_isExact)
            {
                _nearest.begin(_a.solid, _b == null ? null : _b.solid);
                _boxDistances.find(_a.root, _depthA, rootB, _depthB, _nearest);
                out.copyPoints(_nearest.points);
                out.distance = _nearest.points.distance;
            }
            else
            {
                var traversal:DistanceTraversal = _b != null ? _boxDistances : _structureDistances;
                traversal.find(_a.root, _depthA, rootB, _depthB, null);
                traversal.writePoints(out);
            }
            out.distance *= _placementA.size;
            var placement:Placement = _placementA;
            if (areTouching && out.distance > 0 && isOneInside(_a, _b, _leaf.structure))
            {
                var point:Vector3D = _containment.innerPoint;
                out.aX = out.bX = point.x;
                out.aY = out.bY = point.y;
                out.aZ = out.bZ = point.z;
                placement = _containment.isPointOfSecond ? _placementB : _placementA;
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
            return areOverlapping(_a, placementA, _depthA, _b, _leaf.structure, _placementB, _depthB, _isExact);
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

        // Sets the node of a box, in the space of its axes, with the margin of any node.
        private function setBoxLeaf(box:Box):void
        {
            var distance:Number = Math.abs(box.center.x) + Math.abs(box.center.y) + Math.abs(box.center.z);
            var margin:Number = Tolerances.ROUNDING * (box.halfX + box.halfY + box.halfZ + distance);
            _boxLeaf.setHalfExtents(box.halfX + margin, box.halfY + margin, box.halfZ + margin);
            box.place(_pose.placement, _movedBox);
            _boxPose.takeAxesOf(_movedBox, _pose);
        }

        private function prepareTriangles(a:SolidHierarchy, b:SolidHierarchy, structureB:BoundingStructure):LeafTest
        {
            if (b == null)
            {
                _triangles.begin(a, structureB, _pose, RelativeMotion.NONE);
                return _triangles;
            }
            _trianglePairs.begin(a, b);
            return _trianglePairs;
        }

        private function isOneInside(a:SolidHierarchy, b:SolidHierarchy, structureB:BoundingStructure):Boolean
        {
            return b == null ? _containment.isStructureInside(a, moveToFirst(structureB)) : _containment.isOneInside(a, b);
        }

        private function get rootB():HierarchyNode
        {
            return _b == null ? _leaf : _b.root;
        }

        // Finds the first two triangles or nodes that touch while the first model moves.
        private function findFirst():Boolean
        {
            _decider = null;
            _first = _b != null ? _sweptBoxes : _sweptStructures;
            if (_isExact && _b == null)
            {
                _triangles.begin(_a, _leaf.structure, _pose, _pose.motion);
                _decider = _triangles;
            }
            else if (_isExact)
            {
                _sweptPairs.begin(_a, _b);
                _decider = _sweptPairs;
            }
            return _first.find(_a.root, _depthA, rootB, _depthB, _decider);
        }

        // The contact of the two that findFirst has found, at the motion's time.
        private function findContactOfFirst(motion:RelativeMotion, out:ContactPoint):void
        {
            if (!_isExact)
            {
                findContactOf(_first.firstA.bounds, _first.firstB.bounds, motion, out);
                return;
            }
            _pose.motion.time = motion.time;
            _decider.findContact(out);
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
