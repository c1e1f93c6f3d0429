package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * Two placed models: two trees, or a tree and a structure. TreeImpactQuery and TreeDistanceQuery read it.
     *
     * @private
     */
    public final class TreePair
    {
        /** The first model's hierarchy, its placement in the world, and how many levels of its hierarchy are visited. */
        public var a:SolidHierarchy = null;
        public var placementA:Placement = null;
        public var depthA:int = 0;

        /** The second model's hierarchy; null if a structure stands for that model. */
        public var b:SolidHierarchy = null;

        /** That structure, in the second model's space; ignored if b is not null. */
        public var structureB:BoundingStructure = null;

        /** The second model's placement in the world, and how many levels of its hierarchy are visited. */
        public var placementB:Placement = null;
        public var depthB:int = 0;

        /** Whether triangles decide in place of depths. */
        public var isExact:Boolean = false;

        /**
         * Sets the pair. The parameters are those of <code>TreeOverlapQuery.areOverlapping()</code>.
         */
        public function setTo(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, structureB:BoundingStructure,
                placementB:Placement, depthB:int, exact:Boolean):void
        {
            isExact = exact && a.hasTriangles && (b == null || b.hasTriangles);
            this.a = a;
            this.b = b;
            this.structureB = structureB;
            this.placementA = placementA;
            this.placementB = placementB;
            this.depthA = isExact ? int.MAX_VALUE : depthA;
            this.depthB = isExact ? int.MAX_VALUE : depthB;
        }
    }
}
