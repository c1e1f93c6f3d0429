package starlogo.collision
{
    import flash.errors.IllegalOperationError;

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
