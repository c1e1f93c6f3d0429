package starlogo.convex
{
    /**
     * What a test of the ground knows of a contact's depth, as a record: the triangle of the ground that the model is deepest in, and which exits are
     * too short.
     *
     * @private
     */
    public final class GroundDepth
    {
        /** The shortest exit is known to be about as long as this, or longer. It may be a fifth shorter; 0 if nothing is known. */
        public var provenDepth:Number = 0;

        /** Whether the model is known to touch wherever it goes less than the depth along the normal. */
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
            provenDepth = 0;
            isSure = hasTriangle = false;
        }

        /**
         * Sets the triangle.
         *
         * @param corners nine numbers, relative to the origin; they are copied
         * @param x the origin's x in the world; y and z likewise
         */
        public function setTriangle(corners:Vector.<Number>, x:Number, y:Number, z:Number):void
        {
            hasTriangle = true;
            this.x = x;
            this.y = y;
            this.z = z;
            for (var i:int = 0; i < 9; i++)
            {
                this.corners[i] = corners[i];
            }
        }

        /** Becomes the same as another record. */
        public function copyFrom(other:GroundDepth):void
        {
            provenDepth = other.provenDepth;
            isSure = other.isSure;
            hasTriangle = other.hasTriangle;
            if (hasTriangle)
            {
                setTriangle(other.corners, other.x, other.y, other.z);
            }
        }
    }
}
