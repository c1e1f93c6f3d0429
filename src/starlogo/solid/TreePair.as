package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.PosedTrees;

    use namespace engine;

    /**
     * Two placed models: two trees, or a tree and a structure. The queries of trees read it, and set the pose that they need.
     *
     * @private
     */
    public final class TreePair
    {
        /** The first model: its tree, and its placement in the world. */
        public var a:ModelTree = null;
        public var placementA:Placement = null;

        /** The second model: its tree, or a structure in its space that stands for it. The other one is null. */
        public var b:ModelTree = null;
        public var structureB:BoundingStructure = null;
        public var placementB:Placement = null;

        /** Whether triangles decide in place of depths. */
        public var isExact:Boolean = false;

        /** The trees for a traversal, and the second model's pose in the space of the first one. */
        public var trees:PosedTrees = new PosedTrees();

        // Where a motion has brought the first model.
        private var _movedA:Placement = new Placement();

        /**
         * Sets two trees.
         *
         * @param exact whether triangles decide in place of depths, if both trees have triangles
         */
        public function setTrees(a:ModelTree, placementA:Placement, depthA:int, b:ModelTree, placementB:Placement, depthB:int, exact:Boolean):void
        {
            isExact = exact && a.hasTriangles && b.hasTriangles;
            setFirst(a, placementA, depthA);
            this.b = b;
            this.placementB = placementB;
            structureB = null;
            trees.b = b.boxTree;
            trees.depthB = isExact ? BoxTree.EXACT : depthB;
        }

        /**
         * Sets a tree and a structure.
         *
         * @param exact whether triangles decide in place of the depth, if the tree has triangles. Then the two collide if a triangle touches the solid
         *     structure, or if the structure is inside of the tree's closed surface
         */
        public function setTreeAndStructure(a:ModelTree, placementA:Placement, depthA:int, structure:BoundingStructure, placementB:Placement,
                exact:Boolean):void
        {
            isExact = exact && a.hasTriangles;
            setFirst(a, placementA, depthA);
            b = null;
            this.placementB = placementB;
            structureB = structure;
        }

        private function setFirst(a:ModelTree, placementA:Placement, depthA:int):void
        {
            this.a = a;
            this.placementA = placementA;
            trees.a = a.boxTree;
            trees.depthA = isExact ? BoxTree.EXACT : depthA;
        }

        /** Sets the pose to that where both models stand. */
        internal function relate():void
        {
            trees.pose.relate(placementA, placementB);
        }

        /** Sets the pose to that where a motion has brought the first model at a time. */
        internal function relateAt(motion:RelativeMotion, time:Number):void
        {
            var moved:Placement = _movedA;
            moved.copyFrom(placementA);
            moved.x += motion.startX + time * motion.x;
            moved.y += motion.startY + time * motion.y;
            moved.z += motion.startZ + time * motion.z;
            trees.pose.relate(moved, placementB);
        }
    }
}
