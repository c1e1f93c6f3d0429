package starlogo.fitting.hull
{
    /**
     * A point outside of a convex solid, and how the solid grows if the point becomes a corner of it.
     *
     * @private
     */
    public final class OuterPoint
    {
        /** The x coordinate. */
        public var x:Number = 0;

        /** The y coordinate. */
        public var y:Number = 0;

        /** The z coordinate. */
        public var z:Number = 0;

        /** The faces that the point sees. They are inside of the grown solid. More entries than faceCount have no meaning. */
        public var faces:Vector.<int> = new Vector.<int>();

        /** The number of these faces. */
        public var faceCount:int = 0;

        /** How much the volume grows. */
        public var growth:Number = 0;
    }
}
