package starlogo.libraries
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.fitting.HullFitter;

    use namespace engine;

    /**
     * The structures of one shape in the BoundingStructuresLibrary. The index in a list is the kind's number. Kinds with cheaper tests have
     * lower numbers.
     *
     * @private
     */
    public final class ModelStructures
    {
        // the kinds that the library's list of fitters finds: all before HULL
        private static const FITTED:int = BoundingStructure.HULL;

        /**
         * The smallest sphere, capsule and box, or null. It is kept even if the client may not read it, so that it need not be computed
         * again.
         */
        public var smallest:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(FITTED, true);

        /** The hull; the smallest sphere if that is not larger; null if there is none. Set it with setHull(). */
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

        /** Sets the hull, or null. If a sphere around the same vertices, or null, is not larger, it takes the hull's place. */
        public function setHull(found:BoundingStructure, sphere:BoundingStructure):void
        {
            hullOrSphere = found != null && sphere != null && sphere.volume <= found.volume ? sphere : found;
            vertices = found == null ? vertices : null;
        }
    }
}
