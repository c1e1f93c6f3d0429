package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.NodeDivider;
    import starlogo.hierarchy.TreeItems;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /** Prepares a hierarchy's triangles, in steps: boxes down to a few triangles, and the triangles' corners in their order. */
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
            var vertices:Vector.<Number> = _hierarchy.vertices;
            var triangles:Vector.<uint> = _hierarchy.triangles;
            var corners:Vector.<Number> = _solid.corners;
            var to:int = 9 * first;
            for (var i:int = first; i < end; i++)
            {
                var corner:int = 3 * _hierarchy.order[i];
                for (var last:int = corner + 3; corner < last; corner++)
                {
                    var at:int = triangles[corner];
                    at *= 3;
                    corners[to] = vertices[at];
                    corners[int(to + 1)] = vertices[int(at + 1)];
                    corners[int(to + 2)] = vertices[int(at + 2)];
                    to += 3;
                }
            }
        }

        private function conclude():void
        {
            _solid.tree = _hierarchy.tree;
            _hierarchy.items = null;
            _hierarchy.readyFacets = _solid;
        }
    }
}
