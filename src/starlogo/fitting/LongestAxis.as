package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /** The longest axis of the box that a fitter finds: what capsules and cylinders are built around (thesis §3.4.3). */
    internal final class LongestAxis
    {
        /** The box's centre. */
        public var center:Vector3D;

        /** Unit vector along the longest side; the first of equal ones. */
        public var axis:Vector3D;

        /** Half of that side's length. */
        public var half:Number;

        /**
         * @param session the vertices
         * @param boxFitter finds the box
         * @throws ArgumentError if it finds something else
         */
        public function LongestAxis(session:FitSession, boxFitter:Fitter)
        {
            var box:Box = boxFitter.fitOnce(session) as Box;
            if (box == null)
            {
                throw new ArgumentError("the fitter must find a box: " + boxFitter);
            }
            center = box.center;
            axis = box.axisX;
            half = box.halfX;
            if (box.halfY > half)
            {
                axis = box.axisY;
                half = box.halfY;
            }
            if (box.halfZ > half)
            {
                axis = box.axisZ;
                half = box.halfZ;
            }
        }
    }
}
