package starlogo.ground
{
    /**
     * Tells of most models by planes alone whether they touch the ground: a point that is deepest behind a plane is under the ground, or planes separate the two.
     */
    internal final class GroundTouchSearch
    {
        // How far planes must separate the two, as a multiple of the gap across which they touch.
        private static const GAP_MARGINS:Number = 2;

        private var _deepest:DeepestPointSearch = new DeepestPointSearch();
        private var _planes:GroundPlanes = new GroundPlanes();
        private var _separation:GroundSeparation = new GroundSeparation(_planes);

        /**
         * Looks for such a point, or for planes.
         *
         * @param model where it stands
         * @return an answer of GroundSeparation
         */
        public function find(model:ModelPiece, search:GroundSearch):int
        {
            model.findWholeBox();
            _planes.clear();
            if (_deepest.beginUnder(model, search, _planes.next))
            {
                _planes.next.findPoint(model);
                if (_planes.next.depthUnderGround(search, _planes.displacement) >= 0)
                {
                    return GroundSeparation.BLOCKED;
                }
                _planes.add();
            }
            if (!GroundSeparation.isSmall(model.box, search.grid))
            {
                return GroundSeparation.UNKNOWN;
            }
            return _separation.find(model, search, GAP_MARGINS * GroundSeparation.marginOf(model, search.grid));
        }
    }
}
