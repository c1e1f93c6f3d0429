package starlogo.fitting
{
    /** The search for the smallest of many boxes, some rotations a step. */
    public final class RotationFit extends Fit
    {
        private var _stepX:Number;
        private var _stepY:Number;
        private var _stepZ:Number;
        private var _search:RotationSearch = null;
        private var _isSearching:Boolean = true;

        /**
         * @param session the vertices, and their hull
         * @param fitter whose fit it is
         * @param stepX degrees between the rotations about x that are tried
         * @param stepY about y
         * @param stepZ about z
         */
        public function RotationFit(session:FitSession, fitter:Fitter, stepX:Number, stepY:Number, stepZ:Number)
        {
            super(session, fitter);
            _stepX = stepX;
            _stepY = stepY;
            _stepZ = stepZ;
        }

        /** @inheritDoc */
        override protected function advance():Boolean
        {
            if (_search == null)
            {
                _search = new RotationSearch(session.hull);
                _search.begin(_stepX, _stepY, _stepZ);
                return true;
            }
            if (_isSearching)
            {
                _isSearching = _search.step();
                return true;
            }
            finish(Enclosing.box(session.vertices, _search.axes));
            return false;
        }
    }
}
