package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
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
    import starlogo.intersection.sweep.timeOfImpact;

    use namespace engine;

    /**
     * Decides when two hierarchies collide for the first time that pass each other, or one and a structure: the first moment of the motion at
     * which a HierarchyTraversal would say that they do.
     *
     * <p>To come to be inside of a closed surface without having been there at the beginning, a part of a model has to cross it,
     * and its nodes have to touch. So the nodes, or the triangles, are looked at over time, and the standing test is asked at time 0;
     * at time 1 too where nothing was found, so that no rounding hides what stands there.</p>
     *
     * <p>Scratch objects are reused: nothing is allocated once the stacks have grown and the models' triangles were prepared.</p>
     *
     * <p>This file is long because each question is asked of two hierarchies, and of one and a structure.</p>
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

        // Stands for a structure; and a model that is far smaller than the other.
        private var _leaf:HierarchyNode = new HierarchyNode();
        private var _point:Sphere = new Sphere(new Vector3D(), 0);
        private var _turned:RelativeMotion = new RelativeMotion();

        // What decided about the trees that were looked at last: a traversal, and triangles or not.
        private var _traversal:NodePairTraversal;
        private var _isByTriangles:Boolean;

        private var _finder:ContactFinder = new ContactFinder();

        // By kind: a structure of the second model in the space of the first, at time 0.
        private var _moved:Vector.<BoundingStructure> = new <BoundingStructure>[
                new Sphere(new Vector3D(), 0), new Capsule(new Vector3D(), new Vector3D(), 0),
                new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0)];

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
         * When two models collide by their hierarchies.
         *
         * @param a the first model's hierarchy
         * @param placementA where the first model stands
         * @param depthA how many levels of it are visited
         * @param b the second model's hierarchy
         * @param placementB where the second model stands
         * @param depthB how many levels of that are visited
         * @param exact whether, for two hierarchies of triangles, depths do not count and triangles decide
         * @param motion of the first model, relative to the second
         * @return from 0 to 1, or RelativeMotion.NEVER
         */
        public function hierarchiesTouch(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, placementB:Placement,
                depthB:int, exact:Boolean, motion:RelativeMotion):Number
        {
            if (placementB.size > Tolerances.MUCH_LARGER * placementA.size)
            {
                _turned.turn(motion);
                return hierarchiesTouch(b, placementB, depthB, a, placementA, depthA, exact, _turned);
            }
            relate(placementA, placementB, motion);
            if (_standing.hierarchiesOverlap(a, _start, depthA, b, placementB, depthB, exact))
            {
                return 0;
            }
            if (findTrees(a, depthA, b, depthB, exact))
            {
                return _traversal.time;
            }
            moveToEnd(motion);
            return _standing.hierarchiesOverlap(a, _start, depthA, b, placementB, depthB, exact) ? 1 : RelativeMotion.NEVER;
        }

        /**
         * When a model's hierarchy collides with a structure.
         *
         * @param a the model's hierarchy
         * @param placementA where the model stands
         * @param depth how many levels of it are visited
         * @param structure represents another model, in that model's space
         * @param placementB where the other model stands
         * @param motion of the first model, relative to the second
         * @return from 0 to 1, or RelativeMotion.NEVER
         */
        public function structureTouches(a:SolidHierarchy, placementA:Placement, depth:int, structure:BoundingStructure,
                placementB:Placement, motion:RelativeMotion):Number
        {
            if (placementB.size > Tolerances.MUCH_LARGER * placementA.size)
            {
                return pointTouches(a.root, placementA, structure, placementB, motion);
            }
            relate(placementA, placementB, motion);
            if (_standing.structureOverlaps(a, _start, depth, structure, placementB))
            {
                return 0;
            }
            if (findStructure(a.root, depth, structure))
            {
                return _structures.time;
            }
            moveToEnd(motion);
            return _standing.structureOverlaps(a, _start, depth, structure, placementB) ? 1 : RelativeMotion.NEVER;
        }

        /**
         * Where two models touch that collide by their hierarchies: where the first two triangles, or the first two nodes that are leaves or
         * at their depth limit, do; of a model that is inside of another, where the structures around both overlap.
         *
         * @param a as in hierarchiesTouch, and so are the others
         * @param time when they do for the first time
         * @param out takes it, in the world
         */
        public function findContact(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, placementB:Placement, depthB:int,
                exact:Boolean, motion:RelativeMotion, time:Number, out:ContactPoint):void
        {
            if (placementB.size > Tolerances.MUCH_LARGER * placementA.size)
            {
                _turned.turn(motion);
                findContact(b, placementB, depthB, a, placementA, depthA, exact, _turned, time, out);
                out.turn(motion.startX + time * motion.x, motion.startY + time * motion.y, motion.startZ + time * motion.z);
                return;
            }
            relate(placementA, placementB, motion);
            if (!findTrees(a, depthA, b, depthB, exact) || _traversal.time > time + Tolerances.SAME_TIME)
            {
                findContactOf(a.root.bounds, b.root.bounds, time, out);
            }
            else
            {
                findContactOfFirst(time, out);
            }
            moveToWorld(placementA, motion, time, out);
        }

        /**
         * Where a model's hierarchy and a structure touch: where the first node that is a leaf or at its depth limit does, or where the
         * structure around the model overlaps one that is inside.
         *
         * @param a as in structureTouches, and so are the others
         * @param time when they do for the first time
         * @param out takes it, in the world
         */
        public function findStructureContact(a:SolidHierarchy, placementA:Placement, depth:int, structure:BoundingStructure,
                placementB:Placement, motion:RelativeMotion, time:Number, out:ContactPoint):void
        {
            relate(placementA, placementB, motion);
            var isFound:Boolean = findStructure(a.root, depth, structure) && _structures.time <= time + Tolerances.SAME_TIME;
            var node:HierarchyNode = isFound ? _structures.firstA : a.root;
            findContactOf(node.bounds, structure, time, out);
            moveToWorld(placementA, motion, time, out);
        }

        /**
         * When two models touch for the first time that do not touch at the beginning, and where.
         *
         * @param a as in hierarchiesTouch, and so are the others
         * @param out takes it, in the world
         * @return from 0 to 1, or RelativeMotion.NEVER
         */
        public function findImpact(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, placementB:Placement, depthB:int,
                exact:Boolean, motion:RelativeMotion, out:ContactPoint):Number
        {
            if (placementB.size > Tolerances.MUCH_LARGER * placementA.size)
            {
                _turned.turn(motion);
                var time:Number = findImpact(b, placementB, depthB, a, placementA, depthA, exact, _turned, out);
                out.turn(motion.startX + time * motion.x, motion.startY + time * motion.y, motion.startZ + time * motion.z);
                return time;
            }
            relate(placementA, placementB, motion);
            if (!findTrees(a, depthA, b, depthB, exact))
            {
                return RelativeMotion.NEVER;
            }
            time = _traversal.time;
            findContactOfFirst(time, out);
            moveToWorld(placementA, motion, time, out);
            return time;
        }

        /**
         * When a model's hierarchy touches a structure for the first time that it does not touch at the beginning, and where.
         *
         * @param a as in structureTouches, and so are the others
         * @param out takes it, in the world
         * @return from 0 to 1, or RelativeMotion.NEVER
         */
        public function findStructureImpact(a:SolidHierarchy, placementA:Placement, depth:int, structure:BoundingStructure,
                placementB:Placement, motion:RelativeMotion, out:ContactPoint):Number
        {
            relate(placementA, placementB, motion);
            if (!findStructure(a.root, depth, structure))
            {
                return RelativeMotion.NEVER;
            }
            findContactOf(_structures.firstA.bounds, structure, _structures.time, out);
            moveToWorld(placementA, motion, _structures.time, out);
            return _structures.time;
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
            findContactOf(a, b, 0, out);
            moveToWorld(placementA, RelativeMotion.NONE, 0, out);
        }

        private function findTrees(a:SolidHierarchy, depthA:int, b:SolidHierarchy, depthB:int, exact:Boolean):Boolean
        {
            var decider:SweptPairTest = null;
            _isByTriangles = exact && _exact.prepare(a, b);
            if (_isByTriangles)
            {
                decider = _exact;
                depthA = depthB = int.MAX_VALUE;
            }
            _traversal = _structures;
            if (a.boundsKind == BoundingStructure.BOX && b.boundsKind == BoundingStructure.BOX)
            {
                _traversal = _boxes;
            }
            return _traversal.find(a.root, depthA, b.root, depthB, decider);
        }

        private function findStructure(root:HierarchyNode, depth:int, structure:BoundingStructure):Boolean
        {
            _leaf.structure = structure;
            return _structures.find(root, depth, _leaf, 1, null);
        }

        // Of the first two triangles or nodes that findTrees has found.
        private function findContactOfFirst(time:Number, out:ContactPoint):void
        {
            if (_isByTriangles)
            {
                _exact.findContact(time, out);
                return;
            }
            findContactOf(_traversal.firstA.bounds, _traversal.firstB.bounds, time, out);
        }

        // Of two structures in their models' spaces, at a time, in the space of the first.
        private function findContactOf(a:BoundingStructure, b:BoundingStructure, time:Number, out:ContactPoint):void
        {
            var moved:BoundingStructure = b.place(_pose.placement, _moved[b.kind]);
            var motion:RelativeMotion = _pose.motion;
            _finder.find(a, moved, -time * motion.x, -time * motion.y, -time * motion.z, out);
            out.x += time * motion.x;
            out.y += time * motion.y;
            out.z += time * motion.z;
        }

        private static function moveToWorld(a:Placement, motion:RelativeMotion, time:Number, out:ContactPoint):void
        {
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

        private function moveToEnd(motion:RelativeMotion):void
        {
            _start.x += motion.x;
            _start.y += motion.y;
            _start.z += motion.z;
        }

        // The first model is so small that it is a point of the second's space.
        private function pointTouches(root:HierarchyNode, placementA:Placement, structure:BoundingStructure, placementB:Placement,
                motion:RelativeMotion):Number
        {
            _turned.turn(motion);
            relate(placementB, placementA, _turned);
            var relative:Placement = _pose.placement;
            _point.center.setTo(relative.x, relative.y, relative.z);
            _point.radius = relative.size * root.radius + _pose.gap;
            return timeOfImpact(_point, structure, _pose.motion);
        }
    }
}
