package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;

    /** The base of fitters that put a structure along the longest axis of a box (thesis §3.4.3). The box's fitter decides how it lies. */
    public class BoxAxisFitter extends Fitter
    {
        private var _boxFitter:Fitter;

        /**
         * For subclasses only.
         *
         * @param boxFitter finds the box, or the fit fails with an ArgumentError; a library whose list has the same object
         *        computes the box once
         * @throws ArgumentError if it is null
         */
        public function BoxAxisFitter(boxFitter:Fitter)
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
        override public function begin(session:FitSession):Fit
        {
            return new Fit(session, findStructure, _boxFitter.beginOnce(session));
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var box:Box = _boxFitter.fitOnce(session) as Box;
            if (box == null)
            {
                throw new ArgumentError("the fitter must find a box: " + _boxFitter);
            }
            if (box.halfX >= box.halfY && box.halfX >= box.halfZ)
            {
                return findAlong(session.vertices, box.center, box.axisX, box.halfX);
            }
            return box.halfY >= box.halfZ ? findAlong(session.vertices, box.center, box.axisY, box.halfY)
                : findAlong(session.vertices, box.center, box.axisZ, box.halfZ);
        }

        /**
         * What a subclass implements.
         *
         * @param vertices x, y, z each
         * @param center the box's
         * @param axis unit vector along the box's longest side, the first of equal ones
         * @param half half of that side's length
         */
        protected function findAlong(vertices:Vector.<Number>, center:Vector3D, axis:Vector3D, half:Number):BoundingStructure
        {
            return null;
        }
    }
}
