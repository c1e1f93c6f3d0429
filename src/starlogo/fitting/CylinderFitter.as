package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;

    /**
     * The cylinder along the longest axis of a box, as long as the box and as thick as the vertices need (thesis §3.4.3). To be
     * measured and shown, not collided: no intersection test takes cylinders (thesis §3.6.1). Cost beside the box: one pass over
     * the vertices.
     */
    public final class CylinderFitter extends BoxAxisFitter
    {
        /**
         * A fitter of cylinders along the boxes of another fitter.
         *
         * @param boxFitter finds the box, or the fit fails with an ArgumentError
         * @throws ArgumentError if it is null
         */
        public function CylinderFitter(boxFitter:Fitter)
        {
            super(boxFitter);
        }

        /** @inheritDoc */
        override protected function findAlong(vertices:Vector.<Number>, center:Vector3D, axis:Vector3D, half:Number):BoundingStructure
        {
            return EnclosingStructures.cylinder(vertices, center, axis, half);
        }
    }
}
