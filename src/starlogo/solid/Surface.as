package starlogo.solid
{
    /**
     * What a model's triangles are as a whole: whether they close, and how many pieces they come in. See SurfaceBuilder.
     */
    internal final class Surface
    {
        /**
         * Whether the surface separates an inside from the outside: along every edge as many triangles run in one
         * direction as in the other, or, where they are not turned consistently, an even number of them meet. A surface
         * may close in several pieces, which may run into each other.
         */
        public var isClosed:Boolean = true;

        /**
         * Whether it closes with its triangles turned consistently, once those that isTurned says are turned round. Then a
         * point is inside where the surface winds around it; otherwise where a ray from it crosses the surface an odd number
         * of times.
         */
        public var isOriented:Boolean = true;

        /** For each triangle, whether it must be turned round for the surface to be oriented; null if none must. */
        public var isTurned:Vector.<Boolean> = null;

        /** How many connected pieces there are. Pieces that touch but share no vertex are several. */
        public var pieceCount:int = 0;

        /** For each triangle, the piece that it is of, from 0 on. */
        public var pieces:Vector.<int>;

        /** The largest distance of two corners that were taken for one. */
        public var widestSeam:Number = 0;

        /** Made by a SurfaceBuilder. */
        public function Surface()
        {
        }
    }
}
