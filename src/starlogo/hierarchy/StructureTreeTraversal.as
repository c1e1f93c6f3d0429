package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.intersects;

    use namespace engine;

    /**
     * Decides whether trees of spheres or capsules overlap, trees of different structures, or a tree and a single structure: by
     * the pair tests of their kinds.
     *
     * <p>A child's sphere may reach out of its parent's, so that what meets the child need not meet the parent. Still a greater
     * depth never finds more: whatever the depths, nodes are reached in one order, a level of the first tree and then one of the
     * second (thesis §4.6), only by way of ancestors that overlap. Below the last level of one tree, the cover of its node
     * there stands for all its descendants.</p>
     */
    internal final class StructureTreeTraversal
    {
        /** Pairs of nodes that were visited; HierarchyTraversal sets it to 0. */
        public var nodeVisits:int = 0;

        /** Whether the roots overlapped of two trees, or of a tree and a structure, that do not. */
        public var rootsOverlapped:Boolean;

        private var _pose:RelativePose;
        private var _stack:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        // By kind: a structure of the second model in the space of the first.
        private var _moved:Vector.<BoundingStructure> = new <BoundingStructure>[
                new Sphere(new Vector3D(), 0), new Capsule(new Vector3D(), new Vector3D(), 0),
                new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0)];

        /**
         * @param pose where the second model is in the space of the first, whenever two are asked about
         */
        public function StructureTreeTraversal(pose:RelativePose)
        {
            _pose = pose;
        }

        /**
         * Whether two nodes that are leaves or at their depth limit overlap.
         *
         * @param a the root of the first model's hierarchy
         * @param depthA how many levels of it are visited
         * @param b the root of the second model's
         * @param depthB how many levels of that are visited
         * @param exact decides in place of such nodes that overlap, or null
         */
        public function overlap(a:HierarchyNode, depthA:int, b:HierarchyNode, depthB:int, exact:ExactPairTest):Boolean
        {
            var relative:Placement = _pose.placement;
            var stack:Vector.<HierarchyNode> = _stack;
            var top:int = 0;
            var visitsOfRoots:int = nodeVisits + 1;
            while (true)
            {
                nodeVisits++;
                var structureA:BoundingStructure = a.structure;
                var structureB:BoundingStructure = b.structure;
                if (b.level > a.level && a.cover != null)
                {
                    structureA = a.cover;
                }
                else if (structureA == null)
                {
                    structureA = boxOf(a);
                }
                if (a.level > b.level + 1 && b.cover != null)
                {
                    structureB = b.cover;
                }
                else if (structureB == null)
                {
                    structureB = b.bounds;
                }
                var moved:BoundingStructure = structureB.place(relative, _moved[structureB.kind]);
                moved.widen(_pose.gap);
                if (intersects(structureA, moved))
                {
                    var aEnds:Boolean = a.cutoffLevel >= depthA;
                    var bEnds:Boolean = b.cutoffLevel >= depthB;
                    if (aEnds && bEnds)
                    {
                        if (exact == null || exact.leavesTouch(a, b))
                        {
                            return true;
                        }
                    }
                    else if (bEnds || (!aEnds && a.level <= b.level))
                    {
                        var next:HierarchyNode = nearerChild(a, moved);
                        stack[top++] = next === a.left ? a.right : a.left;
                        stack[top++] = b;
                        a = next;
                        continue;
                    }
                    else
                    {
                        stack[top++] = a;
                        stack[top++] = b.right;
                        b = b.left;
                        continue;
                    }
                }
                if (top == 0)
                {
                    rootsOverlapped = nodeVisits > visitsOfRoots;
                    return false;
                }
                b = stack[--top];
                a = stack[--top];
            }
            return false;
        }

        /**
         * Whether a node of the first model that is a leaf or at its depth limit overlaps a structure.
         *
         * @param root of the first model's hierarchy
         * @param depth how many levels of it are visited
         * @param structure of the second model, in its space
         */
        public function structureOverlaps(root:HierarchyNode, depth:int, structure:BoundingStructure):Boolean
        {
            var moved:BoundingStructure = structure.place(_pose.placement, _moved[structure.kind]);
            moved.widen(_pose.gap);
            var stack:Vector.<HierarchyNode> = _stack;
            var node:HierarchyNode = root;
            var top:int = 0;
            var visitsOfRoots:int = nodeVisits + 1;
            while (true)
            {
                nodeVisits++;
                if (intersects(node.structure != null ? node.structure : boxOf(node), moved))
                {
                    if (node.cutoffLevel >= depth)
                    {
                        return true;
                    }
                    var next:HierarchyNode = nearerChild(node, moved);
                    stack[top++] = next === node.left ? node.right : node.left;
                    node = next;
                }
                else if (top == 0)
                {
                    rootsOverlapped = nodeVisits > visitsOfRoots;
                    return false;
                }
                else
                {
                    node = stack[--top];
                }
            }
            return false;
        }

        private function boxOf(node:HierarchyNode):BoundingStructure
        {
            var box:Box = _box;
            var center:Vector3D = box.center;
            center.x = node.x;
            center.y = node.y;
            center.z = node.z;
            box.halfX = node.halfX;
            box.halfY = node.halfY;
            box.halfZ = node.halfZ;
            return box;
        }

        // On the side of the node's middle where the middle of a structure is.
        private static function nearerChild(node:HierarchyNode, structure:BoundingStructure):HierarchyNode
        {
            var at:Vector3D;
            var end:Vector3D;
            if (structure.kind == BoundingStructure.SPHERE)
            {
                at = end = Sphere(structure).center;
            }
            else if (structure.kind == BoundingStructure.CAPSULE)
            {
                at = Capsule(structure).start;
                end = Capsule(structure).end;
            }
            else
            {
                at = end = Box(structure).center;
            }
            var axis:int = node.splitAxis;
            var beyond:Number = at.z + end.z - 2 * node.z;
            if (axis == 0)
            {
                beyond = at.x + end.x - 2 * node.x;
            }
            else if (axis == 1)
            {
                beyond = at.y + end.y - 2 * node.y;
            }
            return beyond > 0 ? node.right : node.left;
        }
    }
}
