package starlogo.queries.motion
{
    /**
     * How a slide may go, as a record. There are four ways: without limits (NONE), at one height (HORIZONTAL), along the ground and walls
     * (WalkPlanner.slideAlong), and down what is steep (Slider.slideDown).
     *
     * @private
     */
    public final class SlideLimits
    {
        /** The least z of the normal of a horizontal floor. */
        public static const HORIZONTAL_Z:Number = 1 - 1e-12;

        /** No limits. It must not be changed. */
        public static const NONE:SlideLimits = new SlideLimits(-Infinity);

        /**
         * For a horizontal motion, which ends as high as it begins: all contacts but horizontal ones are upright walls, and so are the planes of what the body
         * overlaps deeply where it begins. It must not be changed.
         */
        public static const HORIZONTAL:SlideLimits = new SlideLimits(HORIZONTAL_Z);

        /** A contact counts as an upright wall if the z of its normal is less than this, else as a floor. With -Infinity it is neither. */
        public var minFloorNormalZ:Number;

        /** The greatest length of its way on the ground plane. The planes of contacts can turn a motion up or down more level. */
        public var maxHorizontal:Number = Infinity;

        /**
         * The least slope on which a fall goes on, as a tangent; 0 for what is no fall. In each corner a fall begins straight down again. So it has no
         * momentum, and never goes up.
         */
        public var fallSlope:Number = 0;

        /** @param minFloorNormalZ see the field. There are no other limits */
        public function SlideLimits(minFloorNormalZ:Number)
        {
            this.minFloorNormalZ = minFloorNormalZ;
        }
    }
}
