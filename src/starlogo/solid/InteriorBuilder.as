package starlogo.solid
{
    import starlogo.engine;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Prepares a model for exact tests, in steps: the corners and planes of its triangles in the order of the tree, the surface that they make, and
     * the outermost points of its parts. If the surface is known already, most of the work is not needed.
     */
    internal final class InteriorBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        private var _model:ModelTree;
        private var _mesh:TriangleMesh;
        private var _surfaceBuilder:SurfaceBuilder;
        private var _extremes:PartExtremes;

        /** @param model has triangles; receives the triangles, their inside and the surface */
        public function InteriorBuilder(model:ModelTree)
        {
            _model = model;
            _mesh = model.mesh;
            if (_mesh == null)
            {
                _mesh = new TriangleMesh(model.tree);
                sliced(_mesh.placeCorners).call(keepMesh);
            }
            sliced(_mesh.placePlanes).begin(newSurface).call(measureParts);
        }

        private function sliced(work:Function):StepSequence
        {
            return slices(_model.tree.order.length, TRIANGLES_PER_STEP, work);
        }

        private function keepMesh():void
        {
            _model.mesh = _mesh;
        }

        private function newSurface():Steps
        {
            _surfaceBuilder = new SurfaceBuilder(_mesh, _model.surface);
            return _surfaceBuilder;
        }

        private function measureParts():void
        {
            _extremes = new PartExtremes(_mesh.corners, _surfaceBuilder.surface.partNumberEnd);
            sliced(measure).call(conclude);
        }

        private function measure(first:int, end:int):void
        {
            var order:Vector.<int> = _model.tree.order;
            for (var i:int = first; i < end; i++)
            {
                _extremes.add(_surfaceBuilder.surface.parts[order[i]], i);
            }
        }

        private function conclude():void
        {
            _model.interior = new Interior(_surfaceBuilder.windingCounter, _extremes);
            _model.surface = _surfaceBuilder.surface;
        }
    }
}
