package starlogo.libraries
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.Fit;
    import starlogo.fitting.FitSession;
    import starlogo.fitting.Fitter;
    import starlogo.steps.Steps;

    /**
     * Finds the structures of one shape for a BoundingStructuresLibrary, with the library's settings as they were when it
     * began: the hull of the vertices, then what each fitter finds.
     */
    public final class StructuresBuild implements Steps
    {
        private var _name:String;
        private var _cheaperTestsFactor:Number;
        private var _keepsAll:Boolean;
        private var _session:FitSession;
        private var _fitters:Vector.<Fitter>;
        private var _fits:Vector.<Fit> = new Vector.<Fit>();
        private var _found:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
        private var _isHullDone:Boolean = false;
        private var _structures:ShapeStructures = null;

        /**
         * @param name the shape's name
         * @param vertices x, y, z each; not to be changed until the last step is done
         * @param fitters what to compare; copied
         * @param cheaperTestsFactor how much larger than the smallest one the tightest may be for cheaper tests
         * @param keepsAll whether the smallest one of each kind is kept beside the tightest
         * @throws ArgumentError if there are no vertices or a coordinate is missing; if there are no fitters, or one is null
         */
        public function StructuresBuild(name:String, vertices:Vector.<Number>, fitters:Vector.<Fitter>, cheaperTestsFactor:Number,
                keepsAll:Boolean)
        {
            _name = name;
            _cheaperTestsFactor = cheaperTestsFactor;
            _keepsAll = keepsAll;
            if (fitters == null || fitters.length == 0)
            {
                throw named("the library's list of fitters is empty");
            }
            _fitters = fitters.concat();
            try
            {
                begin(vertices);
            }
            catch (error:ArgumentError)
            {
                throw named(error.message);
            }
        }

        /** What was found, when no step is left. */
        public function get structures():ShapeStructures
        {
            return _structures;
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if a coordinate is not finite, or a fitter finds what cannot be collided, or refuses the
         *         vertices; the message names the shape
         */
        public function step():Boolean
        {
            try
            {
                advance();
            }
            catch (error:ArgumentError)
            {
                throw named(error.message);
            }
            return _structures == null;
        }

        private function begin(vertices:Vector.<Number>):void
        {
            _session = new FitSession(vertices, false);
            for each (var fitter:Fitter in _fitters)
            {
                _fits.push(_session.begin(fitter));
            }
        }

        private function advance():void
        {
            if (!_isHullDone)
            {
                _isHullDone = !_session.step();
            }
            else if (!_fits[_found.length].step())
            {
                take(_fitters[_found.length]);
                if (_found.length == _fits.length)
                {
                    _structures = new ShapeStructures(_found, _cheaperTestsFactor, _keepsAll);
                }
            }
        }

        private function take(fitter:Fitter):void
        {
            var structure:BoundingStructure = _session.fit(fitter);
            if (structure == null || structure.kind == BoundingStructure.CYLINDER)
            {
                throw new ArgumentError("the library needs fitters of spheres, capsules or boxes, but " + fitter + " found "
                        + structure);
            }
            _found.push(widened(structure));
        }

        private function named(problem:String):ArgumentError
        {
            return new ArgumentError("shape \"" + _name + "\": " + problem);
        }
    }
}
