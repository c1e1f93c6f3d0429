package starlogo.fitting
{
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
    public final class CapsuleFitter extends Fitter
    {
        private var _boxFitter:Fitter;

        /**
         * A fitter of capsules along the boxes of another fitter.
         *
         * @param boxFitter finds the box, or the fit fails with an ArgumentError; a library whose list has the same object
         *        computes the box once
         * @throws ArgumentError if it is null
         */
        public function CapsuleFitter(boxFitter:Fitter)
        {
            if (boxFitter == null)
            {
                throw new ArgumentError("the box's fitter must not be null");
            }
            _boxFitter = boxFitter;
        }

        /** What finds the box. */
        public function get boxFitter():Fitter
        {
            return _boxFitter;
        }

        /** @inheritDoc */
        override public function get signature():String
        {
            var ofBox:String = _boxFitter.signature;
            return ofBox == null ? null : "capsule of " + ofBox;
        }

        /** @inheritDoc */
        override public function begin(session:FitSession):Fit
        {
            return new Fit(session, findStructure, _boxFitter.beginOnce(session));
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var longest:LongestAxis = new LongestAxis(session, _boxFitter);
            var radius:Number = EnclosingStructures.distanceFromLine(session.vertices, longest.center, longest.axis);
            var half:Number = Math.max(0, longest.half - radius);
            return EnclosingStructures.capsule(session.vertices, longest.center, longest.axis, -half, half, radius);
        }
    }
}
