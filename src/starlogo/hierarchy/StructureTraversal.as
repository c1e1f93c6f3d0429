package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.intersection.intersects;

    use namespace engine;

    /**
     * Decides whether trees of spheres or capsules overlap, trees of different structures, or a tree and a node that stands for a single
     * structure: by the pair tests of their kinds.
     *
     * <p>A child's sphere may reach out of its parent's, so that what meets the child need not meet the parent. Still a greater
     * depth never finds more: whatever the depths, nodes are reached in one order, a level of the first tree and then one of the
     * second (thesis §4.6), only by way of ancestors that overlap. Below the last level of one tree, the cover of its node
     * there stands for all its descendants.</p>
     *
     * @private
     */
    public class StructureTraversal extends NodePairTraversal
    {
        /** The structure of the first model's node that was looked at last. */
        protected var structureA:BoundingStructure;

        /** That of the second model's, in the space of the first. */
        protected var movedB:BoundingStructure;

        // What movedB was made of; and by kind, what it is made in.
        private var _structureB:BoundingStructure;
        private var _moved:Vector.<BoundingStructure> = new <BoundingStructure>[
                new Sphere(new Vector3D(), 0), new Capsule(new Vector3D(), new Vector3D(), 0), newBox()];
        private var _box:Box = newBox();

        /** @inheritDoc */
        public function StructureTraversal(pose:RelativePose)
        {
            super(pose);
        }

        /** @inheritDoc */
        override protected function begin(a:HierarchyNode, b:HierarchyNode):void
        {
            _structureB = null;
            push(a, b);
        }

        /** @inheritDoc */
        override protected function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            placeStructures(a, b);
            return intersects(structureA, movedB);
        }

        /** @inheritDoc */
        override protected function divide(a:HierarchyNode, aEnds:Boolean, b:HierarchyNode, bEnds:Boolean):void
        {
            if (!bEnds && (aEnds || a.level > b.level))
            {
                push(a, b.right);
                push(a, b.left);
            }
            else if (isRightFirst(a))
            {
                push(a.left, b);
                push(a.right, b);
            }
            else
            {
                push(a.right, b);
                push(a.left, b);
            }
        }

        /** Whether the right child of the first model's node is visited first: where the second's structure is on its side of the middle. */
        protected function isRightFirst(a:HierarchyNode):Boolean
        {
            var at:Vector3D;
            var end:Vector3D;
            if (movedB.kind == BoundingStructure.SPHERE)
            {
                at = end = Sphere(movedB).center;
            }
            else if (movedB.kind == BoundingStructure.CAPSULE)
            {
                at = Capsule(movedB).start;
                end = Capsule(movedB).end;
            }
            else
            {
                at = end = Box(movedB).center;
            }
            if (a.splitAxis == 0)
            {
                return at.x + end.x - 2 * a.x > 0;
            }
            if (a.splitAxis == 1)
            {
                return at.y + end.y - 2 * a.y > 0;
            }
            return at.z + end.z - 2 * a.z > 0;
        }

        /** Visits two nodes: finds their structures. */
        protected final function placeStructures(a:HierarchyNode, b:HierarchyNode):void
        {
            nodeVisits++;
            if (b.level > a.level && a.cover != null)
            {
                structureA = a.cover;
            }
            else
            {
                structureA = a.structure == null ? boxOf(a) : a.structure;
            }
            var structureB:BoundingStructure = a.level > b.level + 1 && b.cover != null ? b.cover : b.bounds;
            if (structureB !== _structureB)
            {
                _structureB = structureB;
                movedB = structureB.place(pose.placement, _moved[structureB.kind]);
                movedB.widen(pose.gap);
            }
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

        private static function newBox():Box
        {
            return new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        }
    }
}
