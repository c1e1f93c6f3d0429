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
     * shape is set once. A question takes the triangle: nine numbers of a list, from an index on. ConvexKernel decides.
     *
     * @private
     */
    public final class TriangleKernel
    {
        /** The shape, in the triangles' space. Only its margin may be changed. */
        public var shape:ConvexShape = new ConvexShape();

        private var _kernel:ConvexKernel = new ConvexKernel();
        private var _triangle:ConvexShape = new ConvexShape();

        // The shape where it is placed: a structure for each kind, and a triangle's corners.
        private var _structures:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(BoundingStructure.KIND_COUNT, true);
        private var _placed:Vector.<Number> = new Vector.<Number>();

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
            placed.shapeInto(shape);
            return placed;
        }

        /** Sets the shape to a triangle: nine numbers of a list, from an index on. The placement moves it into the other triangles' space. */
        public function setShapeToTriangle(corners:Vector.<Number>, at:int, placement:Placement):void
        {
            Placement.placePoints(placement, corners, at, at + 9, _placed);
            shape.setTriangle(_placed, 0);
        }

        /** Whether the shape touches a triangle. */
        public function areTouching(corners:Vector.<Number>, at:int):Boolean
        {
            _triangle.setTriangle(corners, at);
            return _kernel.areTouching(shape, _triangle);
        }

        /**
         * Finds when the shape first touches a triangle while it moves.
         *
         * @param motion of the shape; receives the time, or RelativeMotion.NEVER
         */
        public function findTime(corners:Vector.<Number>, at:int, motion:RelativeMotion):void
        {
            _triangle.setTriangle(corners, at);
            _kernel.findTime(shape, _triangle, motion);
        }

        /**
         * Finds how the shape and a triangle touch or overlap.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param out receives the contact, with a normal that points from the triangle to the shape
         */
        public function findContact(corners:Vector.<Number>, at:int, motion:RelativeMotion, out:ContactPoint):void
        {
            _triangle.setTriangle(corners, at);
            _kernel.findContact(shape, _triangle, motion, out);
        }

        /**
         * Finds the closest points of a triangle and the shape, if they are closer than those of a triangle before.
         *
         * @param out the distance and the points of the triangle before; overwritten if this one is closer
         * @return whether it is closer
         */
        public function findCloser(corners:Vector.<Number>, at:int, out:ClosestPoints):Boolean
        {
            _triangle.setTriangle(corners, at);
            return _kernel.findCloser(_triangle, shape, out);
        }
    }
}
