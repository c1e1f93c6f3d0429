package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.timeOfImpact;

    use namespace engine;

    /**
     * Decides when two trees touch that pass each other, or a tree and a structure, where nodes may have spheres or capsules: the first
     * moment at which two nodes that are leaves or at their depth limit touch, and all pairs that StructureTreeTraversal visits before
     * them. A child's structure may reach out of its parent's: hence a pair is looked at for as long only as those before it touch.
     */
    internal final class SweptStructureTrees
    {
        /** Pairs of nodes that were visited; SweptHierarchyTraversal sets it to 0. */
        public var nodeVisits:int = 0;

        /** The nodes that touched first, if any did. */
        public var firstA:HierarchyNode = null;

        /** @copy #firstA */
        public var firstB:HierarchyNode = null;

        private var _pose:RelativePose;

        // Pairs of nodes, and from when to when they touch.
        private var _nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _times:Vector.<Number> = new Vector.<Number>();
        private var _top:int;

        private var _way:RelativeMotion = new RelativeMotion();
        private var _part:RelativeMotion = new RelativeMotion();
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        // By kind: a structure of the second model in the space of the first, at time 0.
        private var _moved:Vector.<BoundingStructure> = new <BoundingStructure>[
                new Sphere(new Vector3D(), 0), new Capsule(new Vector3D(), new Vector3D(), 0),
                new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0)];

        /**
         * @param pose where the second model is in the space of the first at time 0, whenever two are asked about
         */
        public function SweptStructureTrees(pose:RelativePose)
        {
            _pose = pose;
        }

        /**
         * When two nodes that are leaves or at their depth limit touch.
         *
         * @param a the root of the first model's hierarchy
         * @param depthA how many levels of it are visited
         * @param b the root of the second model's
         * @param depthB how many levels of that are visited
         * @param x the way of the second in the space of the first
         * @param y likewise
         * @param z likewise
         * @param exact decides in place of such nodes that touch, or null
         * @return from 0 to 1, or RelativeMotion.NEVER
         */
        public function touch(a:HierarchyNode, depthA:int, b:HierarchyNode, depthB:int, x:Number, y:Number, z:Number,
                exact:SweptPairTest):Number
        {
            begin(x, y, z);
            var earliest:Number = RelativeMotion.NEVER;
            push(a, b, 0, 1);
            while (_top > 0)
            {
                _top -= 2;
                a = _nodes[_top];
                b = _nodes[int(_top + 1)];
                var from:Number = _times[_top];
                var to:Number = _times[int(_top + 1)];
                if (from >= earliest)
                {
                    continue;
                }
                nodeVisits++;
                var structureA:BoundingStructure = a.structure == null ? boxOf(a) : a.structure;
                if (b.level > a.level && a.cover != null)
                {
                    structureA = a.cover;
                }
                var structureB:BoundingStructure = b.structure == null ? b.bounds : b.structure;
                if (a.level > b.level + 1 && b.cover != null)
                {
                    structureB = b.cover;
                }
                var moved:BoundingStructure = structureB.place(_pose.placement, _moved[structureB.kind]);
                moved.widen(_pose.gap);
                from = firstIn(moved, structureA, from, to);
                if (from >= earliest)
                {
                    continue;
                }
                var aEnds:Boolean = a.cutoffLevel >= depthA;
                var bEnds:Boolean = b.cutoffLevel >= depthB;
                if (aEnds && bEnds)
                {
                    if (exact != null)
                    {
                        from = exact.leavesTouch(a, b, earliest < 1 ? earliest : 1);
                    }
                    if (from < earliest)
                    {
                        earliest = from;
                        firstA = a;
                        firstB = b;
                    }
                    if (earliest == 0)
                    {
                        return 0;
                    }
                    continue;
                }
                to = lastIn(moved, structureA, from, to);
                if (bEnds || (!aEnds && a.level <= b.level))
                {
                    push(a.right, b, from, to);
                    push(a.left, b, from, to);
                }
                else
                {
                    push(a, b.right, from, to);
                    push(a, b.left, from, to);
                }
            }
            return earliest;
        }

        /**
         * When a node of the first model that is a leaf or at its depth limit touches a structure.
         *
         * @param root of the first model's hierarchy
         * @param depth how many levels of it are visited
         * @param structure of the second model, in its space
         * @param x the way of the second in the space of the first
         * @param y likewise
         * @param z likewise
         * @return from 0 to 1, or RelativeMotion.NEVER
         */
        public function structureContact(root:HierarchyNode, depth:int, structure:BoundingStructure, x:Number, y:Number,
                z:Number):Number
        {
            begin(x, y, z);
            var moved:BoundingStructure = structure.place(_pose.placement, _moved[structure.kind]);
            moved.widen(_pose.gap);
            var earliest:Number = RelativeMotion.NEVER;
            push(root, null, 0, 1);
            while (_top > 0)
            {
                _top -= 2;
                var node:HierarchyNode = _nodes[_top];
                var from:Number = _times[_top];
                var to:Number = _times[int(_top + 1)];
                if (from >= earliest)
                {
                    continue;
                }
                nodeVisits++;
                var own:BoundingStructure = node.structure == null ? boxOf(node) : node.structure;
                from = firstIn(moved, own, from, to);
                if (from >= earliest)
                {
                    continue;
                }
                if (node.cutoffLevel >= depth)
                {
                    earliest = from;
                    firstA = node;
                    if (earliest == 0)
                    {
                        return 0;
                    }
                    continue;
                }
                // boxes hold those of their children
                to = own.kind == BoundingStructure.BOX ? to : lastIn(moved, own, from, to);
                push(node.right, null, from, to);
                push(node.left, null, from, to);
            }
            return earliest;
        }

        private function begin(x:Number, y:Number, z:Number):void
        {
            _way.x = x;
            _way.y = y;
            _way.z = z;
            firstA = firstB = null;
            _top = 0;
        }

        private function push(a:HierarchyNode, b:HierarchyNode, from:Number, to:Number):void
        {
            _nodes[_top] = a;
            _nodes[int(_top + 1)] = b;
            _times[_top] = from;
            _times[int(_top + 1)] = to;
            _top += 2;
        }

        // When something that moves touches something else for the first time within a part of the way.
        private function firstIn(moved:BoundingStructure, other:BoundingStructure, from:Number, to:Number):Number
        {
            _part.takePart(_way, from, to);
            var time:Number = timeOfImpact(moved, other, _part);
            return time <= 1 ? from + (to - from) * time : RelativeMotion.NEVER;
        }

        // When they touch for the last time, of two that touch in the beginning.
        private function lastIn(moved:BoundingStructure, other:BoundingStructure, from:Number, to:Number):Number
        {
            _part.takePart(_way, to, from);
            var back:Number = timeOfImpact(moved, other, _part);
            return back <= 1 ? to - (to - from) * back : from;
        }

        private function boxOf(node:HierarchyNode):BoundingStructure
        {
            var box:Box = _box;
            box.center.setTo(node.x, node.y, node.z);
            box.halfX = node.halfX;
            box.halfY = node.halfY;
            box.halfZ = node.halfZ;
            return box;
        }
    }
}
