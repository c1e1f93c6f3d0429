package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * Two placed models: two trees, or a tree and a structure. The queries of trees read it.
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

        /** Sets the first model. */
        public function setFirst(model:ModelTree, placement:Placement, depth:int):void
        {
            a = model;
            placementA = placement;
            depthA = depth;
        }

        /** Sets the second model. The structure, in its own space, stands for it if the model is null. */
        public function setSecond(model:ModelTree, structure:BoundingStructure, placement:Placement, depth:int):void
        {
            b = model;
            structureB = structure;
            placementB = placement;
            depthB = depth;
        }

        /**
         * Lets triangles decide in place of depths, if the trees have triangles. Both models must have been set. A tree and a structure collide if a
         * triangle touches the solid structure, or if the structure is inside of the tree's closed surface.
         */
        public function decideByTriangles(exact:Boolean):void
        {
            isExact = exact && a.hasTriangles && (b == null || b.hasTriangles);
            if (isExact)
            {
                depthA = depthB = int.MAX_VALUE;
            }
        }

        /** Copies another pair. */
        public function copyFrom(other:TreePair):void
        {
            setFirst(other.a, other.placementA, other.depthA);
            setSecond(other.b, other.structureB, other.placementB, other.depthB);
            isExact = other.isExact;
        }
    }
}
