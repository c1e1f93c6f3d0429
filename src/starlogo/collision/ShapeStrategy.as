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
         * Computes a shape in the world, its extents, and whether it is a sphere.
         *
         * @throws ArgumentError if what is needed was not loaded
         */
        public function updateWorldShape(shape:WorldShape):void
        {
            throw new IllegalOperationError(this + " does not implement updateWorldShape");
        }

        /** Whether two shapes overlap that are not both spheres, and whose heights and ground rectangles do. */
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
