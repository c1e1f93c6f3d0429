package starlogo.libraries
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.fitting.EnclosingStructures;
    import starlogo.fitting.Fit;
    import starlogo.fitting.FitSession;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.HullFitter;
    import starlogo.geometry.Tolerances;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * Finds the structures of one shape for a BoundingStructuresLibrary. It computes the convex hull of the vertices, and then runs each
     * fitter. It uses the settings that the library had at the beginning.
     *
     * @private
     */
    public final class StructuresBuilder extends StepSequence
    {
        /** The structures, when no step is left. */
        public var structures:ModelStructures = null;

        /** Whether the client may read the smallest structure of each kind. */
        public var keepsAll:Boolean;

        private var _name:String;
        private var _vertices:Vector.<Number>;
        private var _fitters:Vector.<Fitter>;
        private var _fits:Vector.<Fit> = new Vector.<Fit>();
        private var _hullFit:Fit = null;

        /**
         * @param name the shape's name
         * @param vertices x, y, z each; must not change until the last step is done
         * @param fitters the fitters to compare; copied
         * @param hullFitter finds the hull; null if none is wanted
         * @param keepsAll whether the client may read the smallest structure of each kind
         * @throws ArgumentError if there are no fitters, or one is null; the message names the shape
         */
        public function StructuresBuilder(name:String, vertices:Vector.<Number>, fitters:Vector.<Fitter>, hullFitter:HullFitter, keepsAll:Boolean)
        {
            _name = name;
            _vertices = vertices;
            this.keepsAll = keepsAll;
            if (fitters == null || fitters.length == 0)
            {
                throw ModelTable.errorOf(name, "the library's list of fitters is empty");
            }
            if (fitters.indexOf(null) >= 0)
            {
                throw ModelTable.errorOf(name, "a fitter must not be null");
            }
            _fitters = fitters.concat();
            var session:FitSession = new FitSession(vertices, false);
            add(session);
            for each (var fitter:Fitter in _fitters)
            {
                var fit:Fit = fitter.fittingOnce(session);
                _fits.push(fit);
                add(fit);
            }
            if (hullFitter != null)
            {
                _hullFit = hullFitter.fittingOnce(session);
                add(_hullFit);
            }
            slices(fitters.length, 1, check).call(choose);
        }

        /** Whether a hull is wanted too. */
        public function get wantsHull():Boolean
        {
            return _hullFit != null;
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if the vertices are null or empty, if the number of coordinates is not a multiple of 3, or if a
         *     coordinate is not finite; if a fitter finds a structure that cannot be collided or does not enclose the vertices, or
         *     refuses the vertices; the message names the shape
         * @throws RangeError as a structure's constructor
         */
        override public function step():Boolean
        {
            try
            {
                return super.step();
            }
            catch (error:ArgumentError)
            {
                throw ModelTable.errorOf(_name, error.message);
            }
            return false;
        }

        // Throws an ArgumentError if a fitter has found a structure that cannot be used.
        private function check(index:int, end:int):void
        {
            var fitter:Fitter = _fitters[index];
            var structure:BoundingStructure = _fits[index].structure;
            if (structure == null || structure.kind > BoundingStructure.BOX)
            {
                throw new ArgumentError("the library needs fitters of spheres, capsules or boxes, but " + fitter + " found " + structure);
            }
            var outside:int = firstOutside(structure);
            if (outside >= 0)
            {
                throw new ArgumentError(fitter + " found a structure that does not enclose vertex " + outside / 3 + " at ("
                        + _vertices.slice(outside, outside + 3).join(", ") + "): " + structure);
            }
        }

        // The place of the first vertex that is farther outside than the tolerance of a fit; -1 if there is none.
        private function firstOutside(structure:BoundingStructure):int
        {
            var most:Number = EnclosingStructures.sphere(_vertices, _vertices[0], _vertices[1], _vertices[2]).radius;
            var wider:BoundingStructure = structure.clone();
            wider.widen(Tolerances.CONTAINMENT * most);
            var vertex:Vector3D = new Vector3D();
            for (var i:int = 0; i < _vertices.length; i += 3)
            {
                vertex.setTo(_vertices[i], _vertices[i + 1], _vertices[i + 2]);
                if (!wider.contains(vertex))
                {
                    return i;
                }
            }
            return -1;
        }

        private function choose():void
        {
            var found:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
            for each (var fit:Fit in _fits)
            {
                found.push(widened(fit.structure));
            }
            // A HullFitter checks all vertices itself.
            structures = new ModelStructures(found, _hullFit == null ? null : widened(_hullFit.structure), keepsAll);
        }

        /** A copy of a fitted structure, enlarged by the distance at which surfaces still touch. */
        public static function widened(structure:BoundingStructure):BoundingStructure
        {
            var wider:BoundingStructure = structure.clone();
            wider.widenForSurfaces();
            return wider;
        }
    }
}
