package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyRefiner;
    import starlogo.hierarchy.PackedTree;
    import starlogo.hierarchy.TreeItems;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /** Prepares a hierarchy's triangles, in steps: nodes down to a few triangles, packed, and the triangles' corners, extents and planes in their order. */
    internal final class TrianglesBuilder extends StepSequence
    {
        /** The number of triangles in a step. */
        public static const TRIANGLES_PER_STEP:int = 400;

        private var _hierarchy:SolidHierarchy;
        private var _solid:Solid;

        // The normal of the current triangle.
        private var _face:ContactPoint = new ContactPoint();

        /**
         * @param hierarchy of triangles; receives the solid, of which the inside is not known yet
         */
        public function TrianglesBuilder(hierarchy:SolidHierarchy)
        {
            _hierarchy = hierarchy;
            _solid = new Solid(hierarchy.root, hierarchy.order.length);
            add(new HierarchyRefiner(hierarchy)).begin(newTree).slices(hierarchy.order.length, TRIANGLES_PER_STEP, place).call(conclude);
        }

        private function newTree():Steps
        {
            _solid.tree = new PackedTree(_hierarchy.root);
            return _solid.tree;
        }

        private function place(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var corner:int = 3 * _hierarchy.order[i];
                _hierarchy.writeCorners(corner, null, _solid.corners, 9 * i);
                TreeItems.writeExtents(_hierarchy.vertices, _hierarchy.triangles, corner, _solid.extents, 6 * i);
                placePlane(i);
            }
        }

        private function placePlane(triangle:int):void
        {
            var corners:Vector.<Number> = _solid.corners;
            var planes:Vector.<Number> = _solid.planes;
            var at:int = 9 * triangle;
            var to:int = 5 * triangle;
            _face.setTriangleNormal(corners, at);
            if (!(_face.length > 0))
            {
                planes[to] = planes[to + 1] = planes[to + 2] = planes[to + 3] = 0;
                planes[to + 4] = Infinity;
                return;
            }
            _face.measure(corners, at, at + 3);
            var place:Number = _face.least;
            planes[to] = _face.normalX;
            planes[to + 1] = _face.normalY;
            planes[to + 2] = _face.normalZ;
            planes[to + 3] = place;
            _face.measure(corners, at + 3, at + 9);
            planes[to + 4] = Math.max(Math.abs(_face.least - place), Math.abs(_face.greatest - place));
        }

        private function conclude():void
        {
            _hierarchy.placed = _solid;
        }
    }
}
