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
        private var _left:Vector.<Steps>;
        private var _structures:ShapeStructures = null;
        private var _kept:Vector.<BoundingStructure> = null;
        private var _check:EnclosureCheck = null;

        /**
         * @param name the shape's name
         * @param vertices x, y, z each; not to be changed until the last step is done
         * @param fitters what to compare; copied
         * @param cheaperTestsFactor how much larger than the smallest one the tightest may be for cheaper tests
         * @param keepsAll whether the smallest one of each kind is kept beside the tightest
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
            _left = new <Steps>[session];
            for each (var fitter:Fitter in _fitters)
            {
                _fits.push(fitter.beginOnce(session));
                _left.push(_fits[_fits.length - 1]);
            }
        }

        /**
         * Spares the fitters their work, if the structures enclose the model. To be called before the first step.
         *
         * @param kept by the numbers of the kinds, the smallest of each that the fitters found, or null
         */
        public function take(kept:Vector.<BoundingStructure>):void
        {
            _kept = kept;
            _structures = new ShapeStructures(kept.filter(isThere), _cheaperTestsFactor, _keepsAll);
            _check = new EnclosureCheck(_keepsAll ? kept : new <BoundingStructure>[_structures.tightest], _vertices);
        }

        /** Whether what was found was there from the beginning, when no step is left. */
        public function get wasTaken():Boolean
        {
            return _kept != null;
        }

        /** What was found, when no step is left. */
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
            try
            {
                advance();
            }
            catch (error:ArgumentError)
            {
                throw named(error.message);
            }
            return _structures == null || _check != null;
        }

        private function advance():void
        {
            if (_check != null)
            {
                check();
                return;
            }
            if (!_left[0].step())
            {
                _left.shift();
            }
            if (_left.length == 0)
            {
                _structures = new ShapeStructures(found(), _cheaperTestsFactor, _keepsAll);
            }
        }

        private function check():void
        {
            if (_check.step())
            {
                return;
            }
            if (!_check.holds)
            {
                _structures = null;
                _kept = null;
            }
            else if (!_keepsAll)
            {
                _structures.offer();
            }
            _check = null;
        }

        private static function isThere(structure:BoundingStructure, index:int, all:Vector.<BoundingStructure>):Boolean
        {
            return structure != null;
        }

        private function found():Vector.<BoundingStructure>
        {
            var all:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
            for (var i:int = 0; i < _fits.length; i++)
            {
                var structure:BoundingStructure = _fits[i].structure;
                if (structure == null || structure.kind == BoundingStructure.CYLINDER)
                {
                    throw new ArgumentError("the library needs fitters of spheres, capsules or boxes, but " + _fitters[i]
                            + " found " + structure);
                }
                all.push(widened(structure));
            }
            return all;
        }

        private function named(problem:String):ArgumentError
        {
            return new ArgumentError("shape \"" + _name + "\": " + problem);
        }
    }
}
