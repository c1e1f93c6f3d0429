package starlogo.libraries
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.Fit;
    import starlogo.fitting.FitSession;
    import starlogo.fitting.Fitter;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Finds the structures of one shape for a BoundingStructuresLibrary, with the library's settings as they were when it
     * began: the hull of the vertices, then what each fitter finds.
     *
     * @private
     */
    public final class StructuresBuild implements Steps
    {
        private var _name:String;
        private var _vertices:Vector.<Number>;
        private var _cheaperTestsFactor:Number;
        private var _keepsAll:Boolean;
        private var _fitters:Vector.<Fitter>;
        private var _fits:Vector.<Fit> = new Vector.<Fit>();
        private var _work:StepSequence = new StepSequence();
        private var _structures:ShapeStructures = null;
        private var _read:Vector.<BoundingStructure> = null;
        private var _isRead:Boolean = false;

        /**
         * @param name the shape's name
         * @param vertices x, y, z each; not to be changed until the last step is done
         * @param fitters what to compare; copied
         * @param cheaperTestsFactor how much larger than the smallest one the tightest may be for cheaper tests
         * @param keepsAll whether the client is given the smallest one of each kind
         * @throws ArgumentError if there are no fitters, or one is null; the message names the shape
         */
        public function StructuresBuild(name:String, vertices:Vector.<Number>, fitters:Vector.<Fitter>, cheaperTestsFactor:Number,
                keepsAll:Boolean)
        {
            _name = name;
            _vertices = vertices;
            _cheaperTestsFactor = cheaperTestsFactor;
            _keepsAll = keepsAll;
            if (fitters == null || fitters.length == 0)
            {
                throw named("the library's list of fitters is empty");
            }
            if (fitters.indexOf(null) >= 0)
            {
                throw named("a fitter must not be null");
            }
            _fitters = fitters.concat();
            var session:FitSession = new FitSession(vertices, false);
            _work.add(session);
            for each (var fitter:Fitter in _fitters)
            {
                var fit:Fit = fitter.beginOnce(session);
                _fits.push(fit);
                _work.add(fit);
            }
            _work.call(choose);
        }

        /**
         * Uses structures that were read in place of the fitters, if they enclose the model. To be called before the first step.
         *
         * @param read by the numbers of the kinds, the smallest of each that the fitters once found, or null
         */
        public function useRead(read:Vector.<BoundingStructure>):void
        {
            _read = read;
        }

        /** Whether the structures are those that were read, when no step is left. */
        public function get isRead():Boolean
        {
            return _isRead;
        }

        /** The structures, when no step is left. */
        public function get structures():ShapeStructures
        {
            return _structures;
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if the vertices are null or empty, their number of coordinates is no multiple of 3, or one is not
         *         finite; if a fitter finds what cannot be collided, or refuses the vertices; the message names the shape
         */
        public function step():Boolean
        {
            if (_read != null)
            {
                checkRead();
                return !_isRead;
            }
            try
            {
                return _work.step();
            }
            catch (error:ArgumentError)
            {
                throw named(error.message);
            }
            return false;
        }

        private function checkRead():void
        {
            var chosen:ShapeStructures = new ShapeStructures(_read, _cheaperTestsFactor, _keepsAll);
            _isRead = ShapeStructures.areEnclosing(_keepsAll ? _read : new <BoundingStructure>[chosen.tightest], _vertices);
            _read = null;
            if (_isRead)
            {
                _structures = chosen;
                if (!_keepsAll)
                {
                    chosen.trustTightestOnly();
                }
            }
        }

        private function choose():void
        {
            var found:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
            for (var i:int = 0; i < _fits.length; i++)
            {
                var structure:BoundingStructure = _fits[i].structure;
                if (structure == null || structure.kind == BoundingStructure.CYLINDER)
                {
                    throw new ArgumentError("the library needs fitters of spheres, capsules or boxes, but " + _fitters[i]
                            + " found " + structure);
                }
                found.push(widened(structure));
            }
            _structures = new ShapeStructures(found, _cheaperTestsFactor, _keepsAll);
        }

        private function named(problem:String):ArgumentError
        {
            return new ArgumentError("shape \"" + _name + "\": " + problem);
        }
    }
}
