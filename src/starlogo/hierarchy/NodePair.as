package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;

    use namespace engine;

    /**
     * The structures of two nodes, each of another tree, in the space of the first: those that the nodes have, or where one is below the last
     * level of the other tree, a cover of all its descendants for the other.
     */
    internal final class NodePair
    {
        /** The first node's. */
        public var a:BoundingStructure;

        /** The second node's, moved to where it is, and wider by the gap across which shapes touch. */
        public var b:BoundingStructure;

        private var _pose:RelativePose;

        // Which structure of the second model was placed last: numbers, because an object in a field costs Adobe's VM a write barrier.
        private var _levelB:int;
        private var _firstB:int;
        private var _isCoverB:Boolean;

        // By kind: the same in the space of the first.
        private var _moved:Vector.<BoundingStructure> = new <BoundingStructure>[
                new Sphere(new Vector3D(), 0), new Capsule(new Vector3D(), new Vector3D(), 0), newBox()];
        private var _boxA:Box = newBox();
        private var _boxB:Box = newBox();

        /**
         * @param pose where the second model is in the space of the first, whenever two are asked about
         */
        public function NodePair(pose:RelativePose)
        {
            _pose = pose;
        }

        /** Forgets what was placed: the pose has changed. */
        public function begin():void
        {
            _levelB = -1;
        }

        /** Finds the structures of two nodes. */
        public function place(nodeA:HierarchyNode, nodeB:HierarchyNode):void
        {
            var structureA:BoundingStructure = nodeA.structure;
            var structureB:BoundingStructure = nodeB.structure;
            var isCover:Boolean = false;
            if (nodeB.level > 0)
            {
                if (nodeB.level > nodeA.level && nodeA.cover != null)
                {
                    structureA = nodeA.cover;
                }
                if (nodeA.level > nodeB.level + 1 && nodeB.cover != null)
                {
                    structureB = nodeB.cover;
                    isCover = true;
                }
                else if (structureB == null)
                {
                    structureB = nodeB.writeBox(_boxB);
                }
            }
            if (structureA == null)
            {
                structureA = nodeA.writeBox(_boxA);
            }
            var moved:BoundingStructure = _moved[structureB.kind];
            if (nodeB.level != _levelB || nodeB.first != _firstB || isCover != _isCoverB)
            {
                _levelB = nodeB.level;
                _firstB = nodeB.first;
                _isCoverB = isCover;
                structureB.place(_pose.placement, moved);
                _pose.widen(moved);
            }
            a = structureA;
            b = moved;
        }

        private static function newBox():Box
        {
            return new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        }
    }
}
