package starlogo.convex
{
    /**
     * What a test of the ground knows of a contact's depth, as a record: the triangle of the ground that the first shape is deepest in, and which ways
     * out are too short.
     *
     * @private
     */
    public final class GroundDepth
    {
        /** About the length of the shortest way out, which may be a fifth shorter; 0 if none is known. */
        public var leastDepth:Number = 0;

        /** Whether the first shape is known to touch wherever it goes less than the depth along the normal. */
        public var isSure:Boolean = false;

        /** Whether a triangle is known. It is not for a first touch, which may be at an edge of several triangles. */
        public var hasTriangle:Boolean = false;

        /** The triangle's corners, nine numbers. They are relative to the origin. */
        public var corners:Vector.<Number> = new Vector.<Number>(9, true);

        /** The origin, in the world. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** Nothing is known. */
        public function clear():void
        {
            leastDepth = 0;
            isSure = hasTriangle = false;
        }

        /** Becomes the same as another record. */
        public function copyFrom(other:GroundDepth):void
        {
            leastDepth = other.leastDepth;
            isSure = other.isSure;
            hasTriangle = other.hasTriangle;
            x = other.x;
            y = other.y;
            z = other.z;
            for (var i:int = 0; i < 9; i++)
            {
                corners[i] = other.corners[i];
            }
        }
    }
}
