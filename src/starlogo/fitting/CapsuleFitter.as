package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;

    /**
     * The capsule along the longest axis of a box (thesis §3.4.4). Its radius is the largest distance of a vertex from the line
     * through the box's centre along that axis. Its segment starts as what makes the capsule fit into the box's length, a
     * point where the radius leaves nothing; then its ends move outwards just far enough for each vertex.
     *
     * <p>The thesis does not say how far the ends move at once; with the radius fixed there is one least distance for each
     * vertex, so the order of the vertices does not matter.</p>
     *
     * <p>The box's fitter decides how the capsule lies: an oriented box gives an oriented capsule. Cost beside the box: two
     * passes over the vertices. Where two of the box's sides are equally long, the first counts.</p>
     */
    public final class CapsuleFitter extends BoxAxisFitter
    {
        /**
         * A fitter of capsules along the boxes of another fitter.
         *
         * @param boxFitter finds the box, or the fit fails with an ArgumentError; a library whose list has the same object
         *        computes the box once
         * @throws ArgumentError if it is null
         */
        public function CapsuleFitter(boxFitter:Fitter)
        {
            super(boxFitter);
        }

        /** @inheritDoc */
        override public function get signature():String
        {
            return boxFitter.signature == null ? null : "capsule of " + boxFitter.signature;
        }

        /** @inheritDoc */
        override protected function findAlong(vertices:Vector.<Number>, center:Vector3D, axis:Vector3D, half:Number):BoundingStructure
        {
            var radius:Number = EnclosingStructures.distanceFromLine(vertices, center, axis);
            var least:Number = Math.max(0, half - radius);
            return EnclosingStructures.capsule(vertices, center, axis, -least, least, radius);
        }
    }
}
