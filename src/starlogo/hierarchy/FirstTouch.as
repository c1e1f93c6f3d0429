package starlogo.hierarchy
{
    import starlogo.convex.RelativeMotion;

    /**
     * When two models first touch, and which parts of them do, as a record.
     *
     * @private
     */
    public final class FirstTouch
    {
        /** The time: 0 if they touch at the beginning, at most 1, or RelativeMotion.NEVER if they do not touch. Then there are no parts. */
        public var time:Number = RelativeMotion.NEVER;

        /** The part of the first model: a node, or the slot of a triangle if triangles decide. */
        public var a:int = 0;

        /** The part of the second model; without meaning if a structure stands for it. */
        public var b:int = 0;
    }
}
