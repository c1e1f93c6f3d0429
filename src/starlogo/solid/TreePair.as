package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.RelativePose;

    use namespace engine;

    /**
     * Two placed models: two trees, or a tree and a structure. The queries of trees read it, and set the pose that they need.
     *
     * @private
     */
    public final class TreePair
    {
        /** The first model's tree, its placement in the world, and how many levels of its tree are visited. */
        public var a:ModelTree = null;
        public var placementA:Placement = null;
        public var depthA:int = 0;

        /** The second model's tree; null if a structure stands for that model. */
        public var b:ModelTree = null;

        /** That structure, in the second model's space; ignored if b is not null. */
        public var structureB:BoundingStructure = null;

        /** The second model's placement in the world, and how many levels of its tree are visited. */
        public var placementB:Placement = null;
        public var depthB:int = 0;

        /** Whether triangles decide in place of depths. */
        public var isExact:Boolean = false;

        /** The second model's pose in the space of the first one, which transforms the second model there. */
        public var pose:RelativePose = new RelativePose();

        // Where a motion has brought the first model.
        private var _movedA:Placement = new Placement();

        /**
         * Sets both models. The structure, in its own space, stands for the second one if <code>b</code> is null.
         *
         * @param exact whether triangles decide in place of depths, if the trees have triangles. Then a tree and a structure collide if a triangle
         *     touches the solid structure, or if the structure is inside of the tree's closed surface
         */
        public function setTo(a:ModelTree, placementA:Placement, depthA:int, b:ModelTree, structureB:BoundingStructure, placementB:Placement, depthB:int,
                exact:Boolean):void
        {
            this.a = a;
            this.placementA = placementA;
            this.b = b;
            this.structureB = structureB;
            this.placementB = placementB;
            isExact = exact && a.hasTriangles && (b == null || b.hasTriangles);
            this.depthA = isExact ? BoxTree.EXACT : depthA;
            this.depthB = isExact ? BoxTree.EXACT : depthB;
        }

        /** Sets the pose to that where both models stand. */
        internal function relate():void
        {
            pose.relate(placementA, placementB);
        }

        /** Sets the pose to that where a motion has brought the first model at a time. */
        internal function relateAt(motion:RelativeMotion, time:Number):void
        {
            var moved:Placement = _movedA;
            moved.copyFrom(placementA);
            moved.x += motion.startX + time * motion.x;
            moved.y += motion.startY + time * motion.y;
            moved.z += motion.startZ + time * motion.z;
            pose.relate(moved, placementB);
        }
    }
}
