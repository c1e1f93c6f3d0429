package starlogo.ground
{
    /** Triangles of the ground near a piece of a model, as a record. */
    internal final class TriangleList
    {
        /** The triangles, and after them some that are left of longer lists. */
        public var triangles:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();

        /** How many triangles are listed. */
        public var count:int = 0;
    }
}
