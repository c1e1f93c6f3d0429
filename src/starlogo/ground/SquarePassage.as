package starlogo.ground
{
    /**
     * A part of the motion of a GroundSearch's box, as a record: when the box is over a square of the ground, and between which heights. BoxPath finds it,
     * and GroundTriangles and CellTriangles leave out what is not between these heights.
     */
    internal final class SquarePassage
    {
        /** When the part begins and ends, as multiples of the motion. There is no such part if it ends before it begins. */
        public var earliest:Number = 0;
        public var latest:Number = 0;

        /** How far the box is beside the square all the time, along x and y: this distance, multiplied by itself. */
        public var squaredDistanceBeside:Number = 0;

        /** Triangles between these heights count: where the box is then, or as near as the limits of the search say. */
        public var minHeight:Number = 0;
        public var maxHeight:Number = 0;
    }
}
