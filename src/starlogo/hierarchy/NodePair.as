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
     * The structures of two nodes, in the first model's space: of two trees, or of a tree and a node that stands for a single structure.
     */
    internal final class NodePair
    {
        /** The first node's structure. */
        public var a:BoundingStructure;

        /** The second node's structure, moved into the first model's space and enlarged by the gap across which shapes touch. */
        public var b:BoundingStructure;

        private var _pose:RelativePose;

        // Which structure of the second model was placed last. These are numbers, because an object in a field costs Adobe's VM a write
        // barrier.
        private var _levelB:int;
        private var _firstB:int;

        // One object for each kind, for the second node's structure in the first model's space.
        private var _moved:Vector.<BoundingStructure> = new <BoundingStructure>[
                new Sphere(new Vector3D(), 0), new Capsule(new Vector3D(), new Vector3D(), 0), newBox()];
        private var _boxA:Box = newBox();
        private var _boxB:Box = newBox();

        /**
         * @param pose the second model's pose in the first model's space; kept, and read for each pair of models
         */
        public function NodePair(pose:RelativePose)
        {
            _pose = pose;
        }

        /** Forgets the structure placed last, because the pose has changed. */
        public function begin():void
        {
            _levelB = -1;
        }

        /** Finds the structures of two nodes. */
        public function place(nodeA:HierarchyNode, nodeB:HierarchyNode):void
        {
            var structureB:BoundingStructure = nodeB.level > 0 ? nodeB.writeBox(_boxB) : nodeB.structure;
            var moved:BoundingStructure = _moved[structureB.kind];
            if (nodeB.level != _levelB || nodeB.first != _firstB)
            {
                _levelB = nodeB.level;
                _firstB = nodeB.first;
                structureB.place(_pose.placement, moved);
                _pose.widen(moved);
            }
            a = nodeA.writeBox(_boxA);
            b = moved;
        }

        private static function newBox():Box
        {
            return new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        }
    }
}
