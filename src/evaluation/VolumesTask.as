package evaluation
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.AxisAlignedBoxFitter;
    import starlogo.fitting.CapsuleFitter;
    import starlogo.fitting.FitSession;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.HullFitter;
    import starlogo.fitting.MinimalCapsuleFitter;
    import starlogo.fitting.MinimalSphereFitter;
    import starlogo.fitting.NaiveSphereFitter;
    import starlogo.fitting.OrientedBoxFitter;
    import starlogo.fitting.RitterSphereFitter;
    import starlogo.fitting.ZAlignedBoxFitter;
    import starlogo.models.Model;

    /**
     * Figure 6-1: the volumes of the structures around a model, the smallest known ones, hulls, and those of a researcher's own fitters. The
     * z-aligned boxes are fitted in steps of 1 degree, because these volumes agree with the thesis's column on the thesis's own models
     * (figure "nova"). Those in steps of 10 degrees do not.
     */
    public final class VolumesTask extends Task
    {
        private static const MINIMAL:Array = ["minimal sphere", "minimal capsule"];
        private static const HULL:String = "hull";
        private static const DEG_INCREMENT:Number = 10;
        private static const Z_DEG_INCREMENT:Number = 1;

        private var _figure:String;
        private var _model:Model;
        private var _results:Results;
        private var _session:FitSession;
        private var _fitters:Vector.<Fitter>;
        private var _names:Array;
        private var _next:int = 0;

        /**
         * @param figure "volumes", or "nova" for a model of the StarLogo Nova client
         * @param model the model to fit
         * @param settings names a researcher's own fitters
         * @param results takes the volumes
         */
        public function VolumesTask(figure:String, model:Model, settings:Settings, results:Results)
        {
            super("volumes around the " + model.name, 700 + model.vertices.length / 15);
            _figure = figure;
            _model = model;
            _results = results;
            var box:OrientedBoxFitter = new OrientedBoxFitter(DEG_INCREMENT);
            _fitters = new <Fitter>[new NaiveSphereFitter(), new RitterSphereFitter(), new AxisAlignedBoxFitter(),
                    new ZAlignedBoxFitter(Z_DEG_INCREMENT), box, new CapsuleFitter(box), new MinimalSphereFitter(),
                    new MinimalCapsuleFitter(), new HullFitter()];
            _names = Thesis.STRUCTURES.concat(MINIMAL, HULL, settings.fitters);
            for each (var name:String in settings.fitters)
            {
                _fitters.push(settings.own.fitter(name));
            }
        }

        /** @inheritDoc */
        override public function work():Boolean
        {
            _session ||= new FitSession(_model.vertices);
            var structure:BoundingStructure = _session.structureOf(_fitters[_next]);
            var isOfThesis:Boolean = _next < Thesis.STRUCTURES.length;
            var entry:Object = _results.addNumber(_figure, _model.name, _names[_next], structure.volume, "patches^3",
                    isOfThesis ? Thesis.VOLUMES[_model.name][_next] : undefined);
            entry.vertices = _model.vertices.length / 3;
            _next++;
            return _next == _fitters.length;
        }
    }
}
