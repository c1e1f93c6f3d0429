package starlogo.fitting
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.data.requireGiven;

    /**
     * Base class of fitters that put a structure along the longest axis of a box (thesis §3.4.3). Another fitter finds the box, so it
     * decides the structure's direction.
     */
    public class BoxAxisFitter extends Fitter
    {
        private var _boxFitter:Fitter;

        /**
         * For subclasses only.
         *
         * @param boxFitter finds the box; if it finds another structure, the fit throws an ArgumentError. If the same object is also in a
         *     library's list, the library computes the box once
         * @throws ArgumentError if it is null
         */
        public function BoxAxisFitter(boxFitter:Fitter)
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
            return new Fit(session, findStructure, session.fitOf(_boxFitter));
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var box:Box = session.structureOf(_boxFitter) as Box;
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
         * Finds the structure along a box's axis. Subclasses implement it.
         *
         * @param vertices x, y, z of each
         * @param center the box's centre
         * @param axis unit vector along the box's longest side, or along the first of several longest sides
         * @param half half of that side's length
         */
        protected function findAlong(vertices:Vector.<Number>, center:Vector3D, axis:Vector3D, half:Number):BoundingStructure
        {
            throw new IllegalOperationError(this + " does not implement findAlong");
        }
    }
}
