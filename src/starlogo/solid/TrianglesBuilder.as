package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.NodeDivider;
    import starlogo.hierarchy.TreeItems;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /** Prepares a hierarchy's triangles, in steps: boxes down to a few triangles, and the triangles' corners and extents in their order. */
    internal final class TrianglesBuilder extends StepSequence
    {
        /** The number of triangles in a step. */
        public static const TRIANGLES_PER_STEP:int = 400;

        private var _hierarchy:SolidHierarchy;
        private var _solid:Solid;
        private var _divider:NodeDivider = new NodeDivider();

        /**
         * @param hierarchy of triangles; receives the solid, of which the inside is not known yet
         */
        public function TrianglesBuilder(hierarchy:SolidHierarchy)
        {
            _hierarchy = hierarchy;
            _solid = new Solid(hierarchy.root, hierarchy.order);
            var count:int = hierarchy.order.length;
            if (hierarchy.items == null)
            {
                hierarchy.items = new TreeItems(hierarchy.vertices, hierarchy.triangles, hierarchy.order);
                slices(count, TRIANGLES_PER_STEP, hierarchy.items.measure);
            }
            call(divide).add(_divider).slices(count, TRIANGLES_PER_STEP, place).call(conclude);
        }

        private function divide():void
        {
            _divider.beginBelow(_hierarchy);
        }

        private function place(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                _hierarchy.writeCorners(3 * _hierarchy.order[i], null, _solid.corners, 9 * i);
            }
        }

        private function conclude():void
        {
            _solid.tree = _hierarchy.tree;
            _solid.extents = _hierarchy.items.extents;
            _hierarchy.readyFacets = _solid;
        }
    }
}
