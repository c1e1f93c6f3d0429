package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexKernel;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * The kernel of a convex shape and triangles: whether the shape touches a triangle, when and how it first does, and how far the two are apart. The
     * shape is set once for many triangles. Each question takes a triangle as its corners, nine numbers. ConvexKernel decides. The triangle's plane
     * (TrianglePlane) rules out most triangles: callers ask it first.
     *
     * @private
     */
    public final class TriangleKernel
    {
        /**
         * The shape, in the triangles' space. Set it by setStructure(), or itself by ConvexShape.setTriangle(). Its margin may be changed then.
         */
        public var shape:ConvexShape = new ConvexShape();

        private var _kernel:ConvexKernel = new ConvexKernel();
        private var _triangle:ConvexShape = new ConvexShape();

        // The shape where it is placed: a structure for each kind.
        private var _structures:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(BoundingStructure.KIND_COUNT, true);

        /**
         * Sets the shape to a structure.
         *
         * @param structure not kept
         * @param placement moves it into the triangles' space
         * @return the structure there. The next call for the same kind overwrites it
         */
        public function setStructure(structure:BoundingStructure, placement:Placement):BoundingStructure
        {
            var placed:BoundingStructure = _structures[structure.kind] = structure.place(placement, _structures[structure.kind]);
            placed.setShape(shape);
            return placed;
        }

        /** Whether the shape touches a triangle. */
        public function areTouching(corners:Vector.<Number>):Boolean
        {
            _triangle.setTriangle(corners, 0);
            return _kernel.areTouching(shape, _triangle);
        }

        /**
         * Finds when the shape first touches a triangle while it moves.
         *
         * @param motion of the shape; receives the time, or RelativeMotion.NEVER
         */
        public function findTimeOfImpact(corners:Vector.<Number>, motion:RelativeMotion):void
        {
            _triangle.setTriangle(corners, 0);
            _kernel.findTimeOfImpact(shape, _triangle, motion);
        }

        /**
         * Finds how the shape and a triangle touch or overlap.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param out receives the contact, with a normal that points from the triangle to the shape
         */
        public function findContact(corners:Vector.<Number>, motion:RelativeMotion, out:ContactPoint):void
        {
            _triangle.setTriangle(corners, 0);
            _kernel.findContact(shape, _triangle, motion, out);
        }

        /**
         * Finds the closest points of the shape and a triangle, if they are closer than those of a triangle before.
         *
         * @param out the distance and the points of the triangle before, the shape's first; overwritten if this one is closer
         * @return whether it is closer
         */
        public function findCloser(corners:Vector.<Number>, out:ClosestPoints):Boolean
        {
            _triangle.setTriangle(corners, 0);
            return _kernel.findCloser(shape, _triangle, out);
        }
    }
}
