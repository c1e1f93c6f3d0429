package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.NodePairTraversal;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.StructureTraversal;
    import starlogo.hierarchy.SweptBoxTraversal;
    import starlogo.intersection.contact.ContactFinder;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Decides when two hierarchies collide for the first time that pass each other, or one and a structure: the first moment of the motion at
     * which a HierarchyTraversal would say that they do. <code>setPair()</code> says which two; each question has a motion.
     *
     * <p>To come to be inside of a closed surface without having been there at the beginning, a part of a model has to cross it,
     * and its nodes have to touch. So the nodes, or the triangles, are looked at over time, and the standing test is asked at time 0;
     * at time 1 too where nothing was found, so that no rounding hides what stands there.</p>
     *
     * <p>Scratch objects are reused: nothing is allocated once the stacks have grown and the models' triangles were prepared.</p>
     *
     * @private
     */
    public final class SweptHierarchyTraversal
    {
        private var _standing:HierarchyTraversal;
        private var _pose:RelativePose = new RelativePose();
        private var _boxes:SweptBoxTraversal;
        private var _structures:StructureTraversal;
        private var _exact:SweptPairTest;

        // Where the first model is at time 0.
        private var _start:Placement = new Placement();

        // The pair, as setPair says.
        private var _a:SolidHierarchy;
        private var _placementA:Placement;
        private var _depthA:int;
        private var _b:SolidHierarchy;
        private var _structureB:BoundingStructure;
        private var _placementB:Placement;
        private var _depthB:int;
        private var _isExact:Boolean;

        // Stands for a structure.
        private var _leaf:HierarchyNode = new HierarchyNode();

        // What decided about the trees that were looked at last: a traversal, and triangles or not.
        private var _traversal:NodePairTraversal;
        private var _isByTriangles:Boolean;

        private var _finder:ContactFinder = new ContactFinder();

        // By kind: a structure of the second model in the space of the first, at time 0.
        private var _moved:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3, true);

        /**
         * @param standing decides about models that stand still
         */
        public function SweptHierarchyTraversal(standing:HierarchyTraversal)
        {
            _standing = standing;
            _boxes = new SweptBoxTraversal(_pose);
            _structures = new StructureTraversal(_pose, true);
            _exact = new SweptPairTest(_pose);
        }

        /** Pairs of nodes that were visited since resetCounts. */
        public function get nodeVisits():int
        {
            return _boxes.nodeVisits + _structures.nodeVisits;
        }

        /** Pairs of triangles that were tested since resetCounts. */
        public function get triangleTests():int
        {
            return _exact.triangleTests;
        }

        /** Begins to count. */
        public function resetCounts():void
        {
            _boxes.nodeVisits = _structures.nodeVisits = 0;
            _exact.triangleTests = 0;
        }

        /**
         * Sets the pair that is asked about from now on: two hierarchies, or one and a structure.
         *
         * @param a the first model's hierarchy
         * @param placementA where the first model stands
         * @param depthA how many levels of it are visited
         * @param b the second model's hierarchy; null if the structure represents that model
         * @param structureB represents the second model, or is around its hierarchy, in its space
         * @param placementB where the second model stands
         * @param depthB how many levels of its hierarchy are visited
         * @param exact whether, for two hierarchies of triangles, depths do not count and triangles decide
         */
        public function setPair(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, structureB:BoundingStructure,
                placementB:Placement, depthB:int, exact:Boolean):void
        {
            _a = a;
            _placementA = placementA;
            _depthA = depthA;
            _b = b;
            _structureB = structureB;
            _placementB = placementB;
            _depthB = depthB;
            _isExact = exact;
        }

        /**
         * Finds when the two collide.
         *
         * @param motion of the first model, relative to the second; takes the time, from 0 to 1, or RelativeMotion.NEVER
         */
        public function findTime(motion:RelativeMotion):void
        {
            relate(_placementA, _placementB, motion);
            if (isStandingOverlap())
            {
                motion.time = 0;
                return;
            }
            if (findFirst())
            {
                motion.time = _traversal.time;
                return;
            }
            _start.x += motion.x;
            _start.y += motion.y;
            _start.z += motion.z;
            motion.time = isStandingOverlap() ? 1 : RelativeMotion.NEVER;
        }

        /**
         * Where the two touch that collide: where the first two triangles, or the first two nodes that are leaves or at their depth limit, do;
         * of a model that is inside of another, where the structures around both overlap.
         *
         * @param motion of the first model, relative to the second, with the time when they do first
         * @param out takes it, in the world
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            relate(_placementA, _placementB, motion);
            var isOfFirst:Boolean = findFirst() && _traversal.time <= motion.time + Tolerances.SAME_TIME;
            _pose.motion.time = motion.time;
            if (isOfFirst)
            {
                findContactOfFirst(out);
            }
            else
            {
                findContactOf(_a.root.bounds, _structureB, out);
            }
            moveToWorld(_placementA, motion, out);
        }

        /**
         * Finds when the two touch for the first time that do not touch at the beginning, and where.
         *
         * @param motion of the first model, relative to the second; takes the time, from 0 to 1, or RelativeMotion.NEVER
         * @param out takes where, in the world; null if only the time is wanted
         */
        public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            relate(_placementA, _placementB, motion);
            if (!findFirst())
            {
                motion.time = RelativeMotion.NEVER;
                return;
            }
            motion.time = _pose.motion.time = _traversal.time;
            if (out != null)
            {
                findContactOfFirst(out);
                moveToWorld(_placementA, motion, out);
            }
        }

        /**
         * How the structures around two models overlap that stand still.
         *
         * @param a is around the first model, in its space
         * @param placementA where that stands
         * @param b is around the second model, in its space
         * @param placementB where that stands
         * @param out takes it, in the world
         */
        public function findOuterContact(a:BoundingStructure, placementA:Placement, b:BoundingStructure, placementB:Placement,
                out:ContactPoint):void
        {
            relate(placementA, placementB, RelativeMotion.NONE);
            RelativeMotion.NONE.time = _pose.motion.time = 0;
            findContactOf(a, b, out);
            moveToWorld(placementA, RelativeMotion.NONE, out);
        }

        // Whether the two collide where the first is at the time under way.
        private function isStandingOverlap():Boolean
        {
            return _b == null ? _standing.structureOverlaps(_a, _start, _depthA, _structureB, _placementB)
                : _standing.hierarchiesOverlap(_a, _start, _depthA, _b, _placementB, _depthB, _isExact);
        }

        // Finds the first two triangles or nodes that touch as the first model moves.
        private function findFirst():Boolean
        {
            _isByTriangles = false;
            _traversal = _structures;
            if (_b == null)
            {
                _leaf.structure = _structureB;
                return _structures.find(_a.root, _depthA, _leaf, 1, null);
            }
            _isByTriangles = _isExact && _exact.prepare(_a, _b);
            if (_isByTriangles || _a.boundsKind == BoundingStructure.BOX && _b.boundsKind == BoundingStructure.BOX)
            {
                _traversal = _boxes;
            }
            if (_isByTriangles)
            {
                return _traversal.find(_a.root, int.MAX_VALUE, _b.root, int.MAX_VALUE, _exact);
            }
            return _traversal.find(_a.root, _depthA, _b.root, _depthB, null);
        }

        // Of the first two triangles or nodes that findFirst has found.
        private function findContactOfFirst(out:ContactPoint):void
        {
            if (_isByTriangles)
            {
                _exact.findContact(out);
                return;
            }
            findContactOf(_traversal.firstA.bounds, _traversal.firstB.bounds, out);
        }

        // Of two structures in their models' spaces, at the pose's time, in the space of the first.
        private function findContactOf(a:BoundingStructure, b:BoundingStructure, out:ContactPoint):void
        {
            var moved:BoundingStructure = _moved[b.kind] = b.place(_pose.placement, _moved[b.kind]);
            var motion:RelativeMotion = _pose.motion;
            var time:Number = motion.time;
            var displacement:RelativeMotion = _finder.displacement;
            displacement.startX = -time * motion.x;
            displacement.startY = -time * motion.y;
            displacement.startZ = -time * motion.z;
            _finder.find(a, moved, out);
            out.x += time * motion.x;
            out.y += time * motion.y;
            out.z += time * motion.z;
        }

        private static function moveToWorld(a:Placement, motion:RelativeMotion, out:ContactPoint):void
        {
            var time:Number = motion.time;
            var size:Number = a.size;
            var x:Number = out.x * size;
            var y:Number = out.y * size;
            var z:Number = out.z * size;
            out.x = a.r00 * x + a.r01 * y + a.r02 * z + a.x + motion.startX + time * motion.x;
            out.y = a.r10 * x + a.r11 * y + a.r12 * z + a.y + motion.startY + time * motion.y;
            out.z = a.r20 * x + a.r21 * y + a.r22 * z + a.z + motion.startZ + time * motion.z;
            x = out.normalX;
            y = out.normalY;
            z = out.normalZ;
            out.normalX = a.r00 * x + a.r01 * y + a.r02 * z;
            out.normalY = a.r10 * x + a.r11 * y + a.r12 * z;
            out.normalZ = a.r20 * x + a.r21 * y + a.r22 * z;
            out.depth *= size;
        }

        // At time 0.
        private function relate(a:Placement, b:Placement, motion:RelativeMotion):void
        {
            var start:Placement = _start;
            start.copyFrom(a);
            start.x += motion.startX;
            start.y += motion.startY;
            start.z += motion.startZ;
            _pose.relate(start, b);
            _pose.relateMotion(a, motion);
        }
    }
}
