package evaluation
{
    import evaluation.literal.LiteralHierarchyNode;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.Model;

    /** Figure 6-5: the time to build the hierarchy of a model, from its triangles, and from its vertices as in the thesis. */
    public final class HierarchyTask extends MeasuringTask
    {
        private var _model:Model;
        private var _library:HierarchiesLibrary = new HierarchiesLibrary();
        private var _ours:Measurement;
        private var _ofVertices:Measurement;
        private var _literal:Measurement;

        /**
         * @param model the model to divide
         * @param settings says how often
         * @param results takes the times
         */
        public function HierarchyTask(model:Model, settings:Settings, results:Results)
        {
            super("the hierarchy of the " + model.name, settings.repetitions * 130, settings, results);
            _model = model;
        }

        /** @inheritDoc */
        override protected function prepare():void
        {
            _ours = measure("hierarchy", function():void
                {
                    _library.add(_model.name, _model.vertices, _model.triangles);
                }, 1);
            _ofVertices = measure("hierarchy of vertices", function():void
                {
                    _library.add(_model.name, _model.vertices);
                }, 1);
            _literal = measure("literal hierarchy", function():void
                {
                    LiteralHierarchyNode.of(_model.vertices);
                }, 1);
        }

        /** @inheritDoc */
        override protected function conclude():Boolean
        {
            var thesis:Number = Thesis.HIERARCHY_MS[_model.name];
            var entry:Object = _results.addTime("hierarchies", _model.name, "engine", _ours, _base, thesis);
            entry.vertices = _model.vertices.length / 3;
            _results.addTime("hierarchies", _model.name, "engine, vertices", _ofVertices, _base, thesis);
            _results.addTime("hierarchies", _model.name, "literal", _literal, _base);
            return true;
        }
    }
}
