package evaluation
{
    import evaluation.literal.LiteralOrientedBoxFit;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.fitting.FitSession;
    import starlogo.fitting.Fitter;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.models.Model;

    use namespace engine;

    /** Figure 6-2: the time to find the tightest fit of a model, and that of a researcher's own fitters. */
    public final class FitTask extends MeasuringTask
    {
        private static const DEG_INCREMENT:Number = 10;

        private var _model:Model;
        private var _library:BoundingStructuresLibrary = new BoundingStructuresLibrary(DEG_INCREMENT);
        private var _ours:Measurement;
        private var _literal:Measurement;
        private var _settings:Settings;
        private var _others:Vector.<Measurement> = new Vector.<Measurement>();

        /**
         * @param model the model to fit
         * @param settings says how often, and names a researcher's own fitters
         * @param results takes the times
         */
        public function FitTask(model:Model, settings:Settings, results:Results)
        {
            super("fits of the " + model.name, settings.repetitions * (60 + model.vertices.length / 20), settings, results);
            _model = model;
            _settings = settings;
        }

        /** @inheritDoc */
        override protected function prepare():void
        {
            _ours = measure("fit", function():void
                {
                    _library.add(_model.name, _model.vertices);
                }, 1);
            // It tries only a ninth of the rotations, because all of them would create more objects than the player can hold in one call.
            _literal = measure("literal fit", function():void
                {
                    new LiteralOrientedBoxFit(_model.vertices, DEG_INCREMENT, DEG_INCREMENT);
                }, DEG_INCREMENT / 90);
            for each (var name:String in _settings.fitters)
            {
                _others.push(measureFitter(name, _settings.own.fitter(name)));
            }
        }

        /** @inheritDoc */
        override protected function conclude():Boolean
        {
            var tightest:BoundingStructure = _library.tightestFit(_model.name);
            var entry:Object = _results.addTime("fits", _model.name, "engine", _ours, _base, Thesis.FIT_MS[_model.name]);
            entry.vertices = _model.vertices.length / 3;
            entry.tightest = BoundingStructure.NAMES[tightest.kind];
            _results.addTime("fits", _model.name, "literal", _literal, _base);
            for (var i:int = 0; i < _others.length; i++)
            {
                _results.addTime("fits", _model.name, _settings.fitters[i], _others[i], _base);
            }
            return true;
        }

        // The convex hull included, as for the engine's fitters.
        private function measureFitter(name:String, fitter:Fitter):Measurement
        {
            return measure(name, function():void
                {
                    new FitSession(_model.vertices).structureOf(fitter);
                }, 1);
        }
    }
}
