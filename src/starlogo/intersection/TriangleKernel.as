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
     * The kernel of a convex shape and a triangle: whether the two touch, when and how they first touch, and how far they are apart. The shape is set
     * once, and then one triangle after the other, each a part of a list. ConvexKernel decides.
     *
     * @private
     */
    public final class TriangleKernel
    {
        /** The shape, in the triangles' space. Only its margin may be changed. */
        public var shape:ConvexShape = new ConvexShape();

        private var _kernel:ConvexKernel = new ConvexKernel();

        // The shape where it is placed: a structure for each kind, and a triangle's corners.
        private var _structures:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(BoundingStructure.KIND_COUNT, true);
        private var _placed:Vector.<Number> = new Vector.<Number>();

        // The triangle: nine numbers of a list. Its shape is set at the first question.
        private var _corners:Vector.<Number> = null;
        private var _at:int = 0;
        private var _isTriangleSet:Boolean = false;
        private var _triangle:ConvexShape = new ConvexShape();

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
            placement.placePoints(corners, at, at + 9, _placed);
            shape.setTriangle(_placed, 0);
        }

        /**
         * Sets the triangle.
         *
         * @param corners has nine numbers of it; kept
         * @param at index of the first of them
         */
        public function setTriangle(corners:Vector.<Number>, at:int):void
        {
            _corners = corners;
            _at = at;
            _isTriangleSet = false;
        }

        /** Whether the two touch. */
        public function areTouching():Boolean
        {
            prepareTriangle();
            return _kernel.areTouching(shape, _triangle);
        }

        /**
         * Finds when the shape first touches the triangle while it moves.
         *
         * @param motion of the shape; receives the time, or RelativeMotion.NEVER
         */
        public function findTime(motion:RelativeMotion):void
        {
            prepareTriangle();
            _kernel.findTime(shape, _triangle, motion);
        }

        /**
         * Finds how the two touch or overlap.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param out receives the contact, with a normal that points from the triangle to the shape
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            prepareTriangle();
            _kernel.findContact(shape, _triangle, motion, out);
        }

        /**
         * Finds the closest points of the two, if they are closer than those of a triangle before.
         *
         * @param out the distance and the points of the triangle before; overwritten if this one is closer
         * @return whether it is closer
         */
        public function findCloser(out:ClosestPoints):Boolean
        {
            prepareTriangle();
            return _kernel.findCloser(shape, _triangle, out);
        }

        // Sets the triangle's shape, unless a question before has set it.
        private function prepareTriangle():void
        {
            if (!_isTriangleSet)
            {
                _isTriangleSet = true;
                _triangle.setTriangle(_corners, _at);
            }
        }
    }
}
