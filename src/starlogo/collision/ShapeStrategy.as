package starlogo.collision
{
    import flash.errors.IllegalOperationError;
    import starlogo.motion.Touch;
    import starlogo.motion.Way;

    /**
     * What makes one collider differ from another: what stands for an agent's model, where that is in the world, and whether
     * two of them overlap. All the rest is CollisionSearch's.
     */
    internal class ShapeStrategy
    {
        /** For subclasses only. */
        public function ShapeStrategy()
        {
        }

        /**
         * Finds out what stands for the model of a shape's agent.
         *
         * @param shape bound to nothing; the model was added to the GreatLand
         * @throws ArgumentError if what is needed was not loaded
         */
        public function bindModel(shape:WorldShape):void
        {
            throw new IllegalOperationError(this + " does not implement bindModel");
        }

        /**
         * Computes the extents of a shape about its middle, and finds out what decides for it.
         *
         * @param shape its placement's rotation is up to date
         * @throws ArgumentError if what is needed was not loaded
         */
        public function updateWorldShape(shape:WorldShape):void
        {
            throw new IllegalOperationError(this + " does not implement updateWorldShape");
        }

        /** How two boxes are tested that decide alone: by their faces only, as boxBox says? */
        public function get boxFacesOnly():Boolean
        {
            return false;
        }

        /** Whether two shapes overlap that are not both spheres, nor both boxes, and whose heights and ground rectangles do. */
        public function overlaps(a:WorldShape, b:WorldShape):Boolean
        {
            throw new IllegalOperationError(this + " does not implement overlaps");
        }

        /**
         * When two shapes, not both spheres, overlap for the first time as one moves: the first moment at which <code>overlaps()</code> would say
         * so.
         *
         * @param a a shape where it is now
         * @param b another
         * @param way of the first, relative to the second
         * @return from 0 to 1, or Way.NEVER
         */
        public function firstOverlap(a:WorldShape, b:WorldShape, way:Way):Number
        {
            throw new IllegalOperationError(this + " does not implement firstOverlap");
        }

        /**
         * Where two shapes, not both spheres, touch that overlap.
         *
         * @param a as in firstOverlap
         * @param b as in firstOverlap
         * @param way as in firstOverlap
         * @param time when they do first
         * @param out takes it, the normal pointing from b to a, with b where it is now
         */
        public function findTouch(a:WorldShape, b:WorldShape, way:Way, time:Number, out:Touch):void
        {
            throw new IllegalOperationError(this + " does not implement findTouch");
        }

        /** Begins to count the tests of a search. */
        public function resetCounts():void
        {
        }

        /** Adds the tests of the search to their kinds. */
        public function countInto(statistics:CollisionStatistics):void
        {
        }
    }
}
