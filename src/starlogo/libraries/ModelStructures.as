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
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * The structures of one shape in the BoundingStructuresLibrary, and the work that finds them with fitters. The index in a list is the
     * kind's number. Kinds with cheaper tests have lower numbers.
     *
     * @private
     */
    public final class ModelStructures
    {
        // the kinds that the library's list of fitters finds: all before HULL
        private static const FITTED:int = BoundingStructure.HULL;

        private static const VERTICES_PER_STEP:int = 2000;

        /**
         * The smallest sphere, capsule and box, or null. It is kept even if the client may not read it, so that it need not be computed
         * again.
         */
        public var smallest:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(FITTED, true);

        /** The hull; the smallest sphere if that is not larger; null if there is none. */
        public var hullOrSphere:BoundingStructure = null;

        /**
         * The structure with the least volume. Among equal volumes, the one with the cheapest tests. It is the hull only if that is the one
         * structure that was given.
         */
        public var tightest:BoundingStructure = null;

        /** Whether the client may read the smallest structure of each kind: the library's <code>keepAll</code>. */
        public var keepsAll:Boolean;

        /** The vertices that are enclosed; null once there is a hull. If they are a model's own, a pose may have moved them since. */
        public var vertices:Vector.<Number>;

        /** Finds the hull of the vertices, if there is none yet. */
        public var hullFitter:HullFitter;

        /**
         * No structures yet.
         *
         * @param vertices the vertices that are enclosed; kept
         * @param hullFitter finds their hull, if it is needed later
         * @param keepsAll whether the client may read the smallest structure of each kind
         */
        public function ModelStructures(vertices:Vector.<Number>, hullFitter:HullFitter, keepsAll:Boolean)
        {
            this.vertices = vertices;
            this.hullFitter = hullFitter;
            this.keepsAll = keepsAll;
        }

        /**
         * Sets what was found. Call it once.
         *
         * @param found the spheres, capsules and boxes; null entries are ignored
         * @param hull the hull; null if none was wanted
         */
        public function setAll(found:Vector.<BoundingStructure>, hull:BoundingStructure):void
        {
            for each (var structure:BoundingStructure in found)
            {
                if (structure != null && (smallest[structure.kind] == null || structure.volume < smallest[structure.kind].volume))
                {
                    smallest[structure.kind] = structure;
                }
            }
            for each (structure in smallest)
            {
                if (structure != null && (tightest == null || structure.volume < tightest.volume))
                {
                    tightest = structure;
                }
            }
            setHull(hull, smallest[BoundingStructure.SPHERE]);
        }

        /** One structure that is given, not found. It is the tightest, and the smallest of no kind. */
        public static function of(structure:BoundingStructure):ModelStructures
        {
            var given:ModelStructures = new ModelStructures(null, null, false);
            given.tightest = structure;
            return given;
        }

        /**
         * The steps that find the structures. They run each fitter, and check what it finds. The vertices must not change until the last step is done.
         *
         * @param name the shape's name, for messages
         * @param fitters find spheres, capsules and boxes; they count as they are now
         * @param findsHull whether a hull is found too
         * @throws ArgumentError if there is no name or no fitter, or a fitter is null. The steps throw it as the library's <code>add()</code>
         * @throws RangeError by the steps, as the library's <code>add()</code>
         */
        public function finding(name:String, fitters:Vector.<Fitter>, findsHull:Boolean):Steps
        {
            ModelTable.requireName(name);
            if (fitters.length == 0 || fitters.indexOf(null) >= 0)
            {
                throw ModelTable.errorOf(name, fitters.length == 0 ? "the library's list of fitters is empty" : "a fitter must not be null");
            }
            var work:StepSequence = new StepSequence();
            var session:FitSession = new FitSession(vertices);
            var found:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
            for each (var fitter:Fitter in fitters)
            {
                addFit(work, fitter, session, found);
            }
            // a HullFitter checks all vertices itself
            var hullFit:Fit = findsHull ? session.fitOf(hullFitter) : null;
            if (hullFit != null)
            {
                work.add(hullFit);
            }
            work.call(function():void
                {
                    setAll(found, hullFit == null ? null : widened(hullFit.structure));
                });
            return new StepSequence().repeat(function():Boolean
                {
                    try
                    {
                        return work.step();
                    }
                    catch (error:Error)
                    {
                        throw withName(name, error);
                    }
                    return false;
                });
        }

        /**
         * Finds the hull, of the vertices as they are now, if the other structures were found without it.
         *
         * @param name the shape's name, for messages
         * @throws ArgumentError as the library's <code>add()</code>
         * @throws RangeError as the library's <code>add()</code>, if the model was posed since
         */
        public function addHull(name:String):void
        {
            var sphere:BoundingStructure = smallest[BoundingStructure.SPHERE];
            try
            {
                var hull:BoundingStructure = hullFitter.fit(vertices);
                // the vertices may have been posed since the sphere was found
                var isAround:Boolean = sphere != null && firstOutside(sphere, toleranceFor(vertices), vertices, 0, vertices.length / 3) < 0;
                setHull(widened(hull), isAround ? sphere : null);
            }
            catch (error:Error)
            {
                throw withName(name, error);
            }
        }

        // Adds the steps that find a structure, check it, and add it to those that were found.
        private static function addFit(work:StepSequence, fitter:Fitter, session:FitSession, found:Vector.<BoundingStructure>):void
        {
            var fit:Fit = session.fitOf(fitter);
            work.add(fit).begin(function():Steps
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

        // Sets the hull, or null. If a sphere around the same vertices, or null, is not larger, it takes the hull's place.
        private function setHull(found:BoundingStructure, sphere:BoundingStructure):void
        {
            hullOrSphere = found != null && sphere != null && sphere.volume <= found.volume ? sphere : found;
            vertices = found == null ? vertices : null;
        }
    }
}
