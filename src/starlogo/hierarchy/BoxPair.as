package starlogo.hierarchy
{
    /**
     * The boxes of a node's two children, in steps of a PackedTree's grid: their middles and half of their extents. JavaScript engines keep
     * integers in the object itself, but each Number elsewhere in memory.
     *
     * <p>If a child has children, it has a pair. If it is a leaf, its triangles are packed into one number: see PackedTree. The axis is the one
     * along which the node is split.</p>
     */
    internal final class BoxPair
    {
        public var low:BoxPair = null;
        public var high:BoxPair = null;
        public var lowLeaf:int = 0;
        public var highLeaf:int = 0;
        public var axis:int = 0;
        public var lowX:int = 0;
        public var lowY:int = 0;
        public var lowZ:int = 0;
        public var lowHalfX:int = 0;
        public var lowHalfY:int = 0;
        public var lowHalfZ:int = 0;
        public var highX:int = 0;
        public var highY:int = 0;
        public var highZ:int = 0;
        public var highHalfX:int = 0;
        public var highHalfY:int = 0;
        public var highHalfZ:int = 0;
    }
}
