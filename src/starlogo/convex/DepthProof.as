package starlogo.convex
{
    /**
     * What is known of a contact's depth besides the number, as a record: the triangle that the first shape is deepest in, and how long the shortest
     * exit is at least. It is a part of the contact, because the search for the shortest exit gets the contact alone. Only tests of the ground fill it.
     *
     * @private
     */
    public final class DepthProof
    {
        /** The shortest exit is at least about as long as this: it may be a fifth shorter. 0 if nothing is known. */
        public var provenDepth:Number = 0;

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
            hasTriangle = false;
        }

        /**
         * Sets the triangle.
         *
         * @param corners nine numbers, relative to the origin; they are copied
         * @param x the origin's x in the world
         * @param y the origin's y
         * @param z the origin's z
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
        public function copyFrom(other:DepthProof):void
        {
            provenDepth = other.provenDepth;
            hasTriangle = other.hasTriangle;
            if (hasTriangle)
            {
                setTriangle(other.corners, other.x, other.y, other.z);
            }
        }
    }
}
