package starlogo.libraries
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.fitting.EnclosingStructures;
    import starlogo.fitting.Fit;
    import starlogo.fitting.FitSession;
    import starlogo.fitting.Fitter;
    import starlogo.geometry.Tolerances;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * The steps that find the structures of a shape. They run each fitter, and check what it finds. The vertices must not change until the last step
     * is done.
     *
     * @private
     */
    public final class StructuresFit extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 2000;

        // The shape's name, for messages.
        private var _name:String;

        /**
         * @param name the shape's name, for messages
         * @param structures has the vertices, and takes what is found
         * @param fitters find spheres, capsules and boxes; they count as they are now
         * @param findsHull whether a hull is found too
         * @throws ArgumentError if there is no name or no fitter, or a fitter is null. The steps throw it as the library's <code>add()</code>
         * @throws RangeError by the steps, as the library's <code>add()</code>
         */
        public function StructuresFit(name:String, structures:ModelStructures, fitters:Vector.<Fitter>, findsHull:Boolean)
        {
            ModelTable.requireName(name);
            if (fitters.length == 0 || fitters.indexOf(null) >= 0)
            {
                throw ModelTable.errorOf(name, fitters.length == 0 ? "the library's list of fitters is empty" : "a fitter must not be null");
            }
            _name = name;
            var session:FitSession = new FitSession(structures.vertices);
            var found:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
            for each (var fitter:Fitter in fitters)
            {
                addFit(fitter, session, found);
            }
            // a HullFitter checks all vertices itself
            var hullFit:Fit = findsHull ? session.fitOf(structures.hullFitter) : null;
            if (hullFit != null)
            {
                add(hullFit);
            }
            call(function():void
                {
                    structures.setAll(found, hullFit == null ? null : widened(hullFit.structure));
                });
        }

        /** @inheritDoc */
        override public function step():Boolean
        {
            try
            {
                return super.step();
            }
            catch (error:Error)
            {
                throw withName(_name, error);
            }
            return false;
        }

        /**
         * Finds the hull of a shape whose other structures were found without it, of the vertices as they are now.
         *
         * @throws ArgumentError as the library's <code>add()</code>
         * @throws RangeError as the library's <code>add()</code>, if the model was posed since
         */
        public static function addHull(name:String, structures:ModelStructures):void
        {
            var vertices:Vector.<Number> = structures.vertices;
            var sphere:BoundingStructure = structures.smallest[BoundingStructure.SPHERE];
            try
            {
                var hull:BoundingStructure = structures.hullFitter.fit(vertices);
                // the vertices may have been posed since the sphere was found
                var isAround:Boolean = sphere != null && firstOutside(sphere, toleranceFor(vertices), vertices, 0, vertices.length / 3) < 0;
                structures.setHull(widened(hull), isAround ? sphere : null);
            }
            catch (error:Error)
            {
                throw withName(name, error);
            }
        }

        // Adds the steps that find a structure, check it, and add it to those that were found.
        private function addFit(fitter:Fitter, session:FitSession, found:Vector.<BoundingStructure>):void
        {
            var fit:Fit = session.fitOf(fitter);
            add(fit).begin(function():Steps
                {
                    return checking(fitter, fit.structure, session.vertices);
                }).call(function():void
                {
                    found.push(widened(fit.structure));
                });
        }

        // A copy of a fitted structure, enlarged by the distance at which surfaces still touch.
        private static function widened(structure:BoundingStructure):BoundingStructure
        {
            var wider:BoundingStructure = structure.clone();
            wider.widenForSurfaces();
            return wider;
        }

        // The error of a fitter, with the shape's name. The error may be the fitter's own, so it is not changed.
        private static function withName(name:String, error:Error):Error
        {
            return error is ArgumentError ? ModelTable.errorOf(name, error.message)
                : (error is RangeError ? new RangeError(ModelTable.problemOf(name, error.message)) : error);
        }

        // The steps that check whether what a fitter has found can be used.
        private static function checking(fitter:Fitter, structure:BoundingStructure, vertices:Vector.<Number>):Steps
        {
            // In JavaScript, a fitter may return anything.
            if (!(structure is BoundingStructure) || structure.kind > BoundingStructure.BOX)
            {
                throw new ArgumentError("the library needs fitters of spheres, capsules or boxes, but " + fitter + " found " + structure);
            }
            var tolerance:Number = toleranceFor(vertices);
            return new StepSequence().slices(vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    var outside:int = firstOutside(structure, tolerance, vertices, first, end);
                    if (outside >= 0)
                    {
                        throw new ArgumentError(fitter + " found a structure that does not enclose vertex " + outside + " at ("
                                + vertices.slice(3 * outside, 3 * outside + 3).join(", ") + "): " + structure);
                    }
                });
        }

        // how far outside of a structure vertices may be
        private static function toleranceFor(vertices:Vector.<Number>):Number
        {
            return Tolerances.CONTAINMENT * EnclosingStructures.sphere(vertices, new Vector3D(vertices[0], vertices[1], vertices[2])).radius;
        }

        // The index of the first of some vertices that is further outside of a structure than a tolerance; -1 if there is none.
        private static function firstOutside(structure:BoundingStructure, tolerance:Number, vertices:Vector.<Number>, first:int, end:int):int
        {
            var wider:BoundingStructure = structure.clone();
            var vertex:Vector3D = new Vector3D();
            wider.widen(tolerance);
            for (var i:int = first; i < end; i++)
            {
                vertex.setTo(vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]);
                if (!wider.contains(vertex))
                {
                    return i;
                }
            }
            return -1;
        }
    }
}
