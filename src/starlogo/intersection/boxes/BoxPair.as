// The package intersection.boxes decides about two boxes by separating axes: the three of a, the three of b, and the nine across an edge of each
// (Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996). Boxes are apart if one of these axes separates them. Two classes project the boxes on them,
// because they need different arithmetic. KernelsAgreeTest checks that both agree.
// 
// - BoxSeparation is for boxes that stand. An axis across edges takes a few products, which cancel if the edges are nearly parallel. Then boxBox asks
// BoxSweep.
// - BoxSweep is for boxes that move. Each axis gives an interval of time. It projects the boxes in full on the axes across edges, so nothing cancels,
// but that takes longer.
// 
// The depth of two boxes comes from SatPenetration, which knows the faces and edges of all convex shapes. Read BoxPair first.

package starlogo.intersection.boxes
{
    import starlogo.bounding.Box;
    import starlogo.convex.RelativeMotion;

    /**
     * Two boxes, as a record: where box b is at time 0 as seen from box a, how it moves until time 1, and the time of impact that BoxSweep writes. All
     * numbers are in the axes of a. Many pairs of boxes may have the same axes and motion. Then these are set once for all of them. Tests of boxes
     * that stand use no more than the axes, the vector and the half-extents.
     *
     * @private
     */
    public final class BoxPair
    {
        /** The pair that <code>boxBox()</code> sets, whose boxes stand. */
        public static const SCRATCH:BoxPair = new BoxPair();

        /** The axes of b. */
        public var axes:BoxAxes = new BoxAxes();

        /** The motion of b from time 0 to 1 as seen from a. */
        public var motionX:Number = 0;
        public var motionY:Number = 0;
        public var motionZ:Number = 0;

        /** The gap across which the boxes still touch: the sum of the margins (see Touching). */
        public var margin:Number = 0;

        /** The vector from a's middle to b's at time 0. boxBox() shortens it in place of a margin. */
        public var offsetX:Number = 0;
        public var offsetY:Number = 0;
        public var offsetZ:Number = 0;

        /** The half-extents of a. */
        public var aHalfX:Number = 0;
        public var aHalfY:Number = 0;
        public var aHalfZ:Number = 0;

        /** The half-extents of b. */
        public var bHalfX:Number = 0;
        public var bHalfY:Number = 0;
        public var bHalfZ:Number = 0;

        /** The latest time that counts: see RelativeMotion. */
        public var latestTime:Number = 1;

        /** The result: the time from which the axes that were tried do not separate the boxes, or RelativeMotion.NEVER. */
        public var time:Number = RelativeMotion.NEVER;

        /** Sets the half-extents. */
        public function setHalves(a:Box, b:Box):void
        {
            aHalfX = a.halfX;
            aHalfY = a.halfY;
            aHalfZ = a.halfZ;
            bHalfX = b.halfX;
            bHalfY = b.halfY;
            bHalfZ = b.halfZ;
        }
    }
}
