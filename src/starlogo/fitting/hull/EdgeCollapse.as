package starlogo.fitting.hull
{
    /**
     * How an edge of a ProgressiveHull can collapse, as a record: the new corner, and what changes.
     *
     * @private
     */
    public final class EdgeCollapse
    {
        /** The new corner. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The faces that the corner sees. They are inside of the solid afterwards. More entries than faceCount have no meaning. */
        public var faces:Vector.<int> = new Vector.<int>();

        /** The number of these faces. */
        public var faceCount:int = 0;

        /** How much the solid grows. */
        public var growth:Number = 0;
    }
}
