package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Cylinder;
    import starlogo.data.requireGiven;

    /**
     * Finds the bounding cylinder along the longest axis of a box (thesis §3.4.3). It is as long as the box, and just thick enough for the
     * vertices. Cylinders are measured and shown, but not collided: no intersection test takes them (thesis §3.6.1). In addition to the
     * box, it takes one pass over the vertices. It has no signature, because a Cylinder has no numbers to store (BoundingStructure.toNumbers).
     */
    public final class CylinderFitter extends Fitter
    {
        private var _boxFitter:Fitter;

        /**
         * Creates a fitter of cylinders along the boxes of another fitter.
         *
         * @param boxFitter finds the box; if it finds another structure, the fit throws an ArgumentError
         * @throws ArgumentError if it is null
         */
        public function CylinderFitter(boxFitter:Fitter)
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
        override public function fitting(session:FitSession):Fit
        {
            return fittingAlongBox(session, _boxFitter, findAlong);
        }

        private static function findAlong(vertices:Vector.<Number>, center:Vector3D, axis:Vector3D, half:Number):BoundingStructure
        {
            return new Cylinder(new Vector3D(center.x - half * axis.x, center.y - half * axis.y, center.z - half * axis.z),
                    new Vector3D(center.x + half * axis.x, center.y + half * axis.y, center.z + half * axis.z),
                    EnclosingStructures.distanceFromLine(vertices, center, axis));
        }
    }
}
