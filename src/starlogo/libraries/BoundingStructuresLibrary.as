package starlogo.libraries
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.fitting.CapsuleFitter;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.HullFitter;
    import starlogo.fitting.NaiveSphereFitter;
    import starlogo.fitting.OrientedBoxFitter;
    import starlogo.models.Model;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The tightest bounding structure of each model, found by the name of its shape (thesis §3.7). The structures are computed when a model
     * is added. A setting that you change counts for models that are added afterwards.
     *
     * <p>The library's structures are shared by all agents of a shape, so looking one up costs nothing. Do not change them:
     * <code>clone()</code> a structure first.</p>
     */
    public final class BoundingStructuresLibrary
    {
        /**
         * Whether clients may read the smallest sphere, box and capsule, in addition to the tightest fit (thesis §3.8). A GreatLand sets it
         * as loadAllBoundingStructures.
         */
        public var keepAll:Boolean = false;

        /**
         * Whether a hull is found too when a model is added, for agents that collide as "hull". Without it, a hull is found when an agent
         * first needs it. It has no effect on the tightest fit. A GreatLand sets it as loadHulls.
         */
        public var keepHulls:Boolean = false;

        /** @private What was computed for each shape. The libraries of a GreatLand share its table. */
        engine var models:ModelTable = new ModelTable();

        private var _orientedBoxFitter:OrientedBoxFitter;
        private var _fitters:Vector.<Fitter>;
        private var _hullFitter:HullFitter = new HullFitter();

        /**
         * Creates a library without models, with the three fitters of the thesis.
         *
         * @param orientedBoxDegIncrement degrees between the rotations that the default fitters try
         * @throws ArgumentError if that is less than 0.01, or not finite
         */
        public function BoundingStructuresLibrary(orientedBoxDegIncrement:Number = 10)
        {
            _orientedBoxFitter = new OrientedBoxFitter(orientedBoxDegIncrement);
            _fitters = new <Fitter>[new NaiveSphereFitter(), _orientedBoxFitter, new CapsuleFitter(_orientedBoxFitter)];
        }

        /**
         * The algorithms that are compared when a model is added. You may change the list or replace it at any time; this counts for models that
         * are added afterwards. The default: the naive sphere, the oriented box, and the capsule of that box. The box is then computed only once.
         *
         * @throws ArgumentError if you set it to null, to an empty list or to a list that contains null
         */
        public function get fitters():Vector.<Fitter>
        {
            return _fitters;
        }

        public function set fitters(value:Vector.<Fitter>):void
        {
            if (value == null || value.length == 0 || value.indexOf(null) >= 0)
            {
                throw new ArgumentError("fitters must be a list of at least one Fitter, without null: " + value);
            }
            _fitters = value;
        }

        /**
         * The algorithm that finds hulls. The default: a HullFitter of 16 corners.
         *
         * @throws ArgumentError if you set it to null
         */
        public function get hullFitter():HullFitter
        {
            return _hullFitter;
        }

        public function set hullFitter(value:HullFitter):void
        {
            requireGiven("the hullFitter", value);
            _hullFitter = value;
        }

        /**
         * The degrees between the rotations that the default oriented box fitter tries (thesis §3.8). The default capsule is that of this
         * box, so it changes too. It has no effect on fitters that you put into the list.
         *
         * @throws ArgumentError if you set it to a value that is less than 0.01, or not finite
         */
        public function get orientedBoxDegIncrement():Number
        {
            return _orientedBoxFitter.degIncrement;
        }

        public function set orientedBoxDegIncrement(value:Number):void
        {
            _orientedBoxFitter.degIncrement = value;
        }

        /**
         * Finds and stores the structures of a model. They replace those stored under the same name. If it throws, nothing has changed.
         *
         * @param name the shape's name
         * @param vertices x, y, z of each vertex, in the model's space; copied for a hull that is found later, unless it is found now, or
         * they are the list <code>vertices</code> of the GreatLand's model of this name
         * @throws ArgumentError if the name is null or empty; if the vertices are null or empty, if the number of coordinates is not a
         *     multiple of 3, or if a coordinate is not finite or beyond 1e60; if the list of fitters is empty, or one of them finds a structure
         *     that cannot be collided or does not enclose the vertices
         * @throws RangeError if the vertices are in different places, but less than 2e-70 apart along each axis, or if a fitter finds a
         *     structure with a number that is not finite, or beyond the limits of structures
         */
        public function add(name:String, vertices:Vector.<Number>):void
        {
            var entry:ModelEntry = models.entryOf(name);
            var model:Model = entry.model;
            var needsCopy:Boolean = vertices != null && !keepHulls && (model == null || vertices != model.vertices);
            var structures:ModelStructures = new ModelStructures(needsCopy ? vertices.concat() : vertices, hullFitter, keepAll);
            finish(new StructuresFit(name, structures, fitters, keepHulls));
            models.entryToWrite(name).replace(model, structures, entry.tree);
        }

        /** Whether the library has structures for a shape. */
        public function has(name:String):Boolean
        {
            return models.entryOf(name).structures != null;
        }

        /**
         * The tightest fit of a shape. It is shared: do not change it.
         *
         * @throws ArgumentError if the library has nothing of this name
         */
        public function tightestFit(name:String):BoundingStructure
        {
            return structuresOf(name).tightest;
        }

        /**
         * The smallest sphere found for a shape. It is shared: do not change it.
         *
         * @throws ArgumentError if the library has nothing of this name, or no sphere is kept for it (keepAll)
         */
        public function sphere(name:String):Sphere
        {
            return Sphere(keptOf(name, BoundingStructure.SPHERE));
        }

        /**
         * The smallest box found for a shape. It is shared: do not change it.
         *
         * @throws ArgumentError if the library has nothing of this name, or no box is kept for it (keepAll)
         */
        public function box(name:String):Box
        {
            return Box(keptOf(name, BoundingStructure.BOX));
        }

        /**
         * The smallest capsule found for a shape. It is shared: do not change it.
         *
         * @throws ArgumentError if the library has nothing of this name, or no capsule is kept for it (keepAll)
         */
        public function capsule(name:String):Capsule
        {
            return Capsule(keptOf(name, BoundingStructure.CAPSULE));
        }

        /**
         * The hull found for a shape, when its model was added or when an agent first needed it. If the smallest sphere found is not larger,
         * it is that Sphere. It is shared: do not change it.
         *
         * @throws ArgumentError if the library has nothing of this name, or no hull was found for it yet
         */
        public function hull(name:String):BoundingStructure
        {
            var found:BoundingStructure = structuresOf(name).hullOrSphere;
            if (found == null)
            {
                throw ModelTable.errorOf(name, "it has no hull yet: set loadHulls (keepHulls) before the model is added");
            }
            return found;
        }

        /** Whether a sphere, a box and a capsule are kept for a shape. */
        public function hasAll(name:String):Boolean
        {
            var structures:ModelStructures = models.entryOf(name).structures;
            return structures != null && structures.keepsAll && structures.smallest.indexOf(null) < 0;
        }

        /** Whether there is a hull for a shape by now, or a sphere in its place. */
        public function hasHull(name:String):Boolean
        {
            var structures:ModelStructures = models.entryOf(name).structures;
            return structures != null && structures.hullOrSphere != null;
        }

        /**
         * The smallest structure of a kind for a shape. A hull that was not found with the others is found now. From then on clients may read
         * it.
         *
         * @param name the shape's name
         * @param kind BoundingStructure.SPHERE, CAPSULE, BOX or HULL. In place of a hull it may be a sphere
         * @throws ArgumentError if the library has nothing of this name, or no fitter found this kind when the model was added
         * @throws RangeError as <code>add()</code>, if the model was posed since
         * @private
         */
        engine function findOrFit(name:String, kind:int):BoundingStructure
        {
            var structures:ModelStructures = structuresOf(name);
            if (kind == BoundingStructure.HULL && structures.hullOrSphere == null)
            {
                StructuresFit.addHull(name, structures);
            }
            var found:BoundingStructure = kind == BoundingStructure.HULL ? structures.hullOrSphere : structures.smallest[kind];
            if (found == null)
            {
                throw ModelTable.errorOf(name, "it cannot be a " + BoundingStructure.NAMES[kind] + ": no fitter found one when its model was added");
            }
            return found;
        }

        private function structuresOf(name:String):ModelStructures
        {
            var structures:ModelStructures = models.entryOf(name).structures;
            if (structures == null)
            {
                throw models.missing("bounding structure", name, "loadTightestFit");
            }
            return structures;
        }

        private function keptOf(name:String, kind:int):BoundingStructure
        {
            var structures:ModelStructures = structuresOf(name);
            if (!structures.keepsAll || structures.smallest[kind] == null)
            {
                throw ModelTable.errorOf(name, "it shows no " + BoundingStructure.NAMES[kind] + ": set loadAllBoundingStructures (keepAll) before the model is added, "
                        + "and have a fitter that finds one in the list");
            }
            return structures.smallest[kind];
        }
    }
}
