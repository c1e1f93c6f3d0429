package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.data.requireGiven;

    /**
     * Finds a bounding capsule along the longest axis of a box (thesis §3.4.4). Another fitter finds the box: an oriented box gives an
     * oriented capsule.
     *
     * <p>The radius is the largest distance of a vertex from the line through the box's centre along that axis. At first, the segment is
     * so short that the capsule just fits into the box's length. If the radius leaves no length, the segment is a point at first. Then
     * its ends move outwards just far enough for each vertex. If two sides of the box are equally long, the first one is taken.</p>
     *
     * <p>The thesis does not say how far the ends move at a time. For a fixed radius, each vertex needs the ends at a certain distance or
     * farther out. So the order of the vertices does not matter here.</p>
     *
     * <p>In addition to the box, it takes two passes over the vertices.</p>
     */
    public final class CapsuleFitter extends Fitter
    {
        private var _boxFitter:Fitter;

        /**
         * Creates a fitter of capsules along the boxes of another fitter.
         *
         * @param boxFitter finds the box; if it finds another structure, the fit throws an ArgumentError. If the same object, or a fitter
         *     of the same signature, is also in a library's list, the library computes the box once
         * @throws ArgumentError if it is null
         */
        public function CapsuleFitter(boxFitter:Fitter)
        {
            requireGiven("the box's fitter", boxFitter);
            _boxFitter = boxFitter;
        }

        /** The fitter that finds the box. */
        public function get boxFitter():Fitter
        {
            return _boxFitter;
        }

        /** @inheritDoc */
        override public function get signature():String
        {
            return _boxFitter.signature ? "capsule of " + _boxFitter.signature : null;
        }

        /** @inheritDoc */
        override public function fitting(session:FitSession):Fit
        {
            return fittingAlongBox(session, _boxFitter, findAlong);
        }

        private static function findAlong(vertices:Vector.<Number>, center:Vector3D, axis:Vector3D, half:Number):BoundingStructure
        {
            var radius:Number = EnclosingStructures.distanceFromLine(vertices, center, axis);
            var least:Number = Math.max(0, half - radius);
            return EnclosingStructures.capsule(vertices, center, axis, -least, least, radius);
        }
    }
}
