package starlogo.libraries
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.fitting.CapsuleFitter;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.NaiveSphereFitter;
    import starlogo.fitting.OrientedBoxFitter;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The tightest fitting bounding structure of each model, by the name of its shape (thesis §3.7). A model's structures are
     * computed when it is added; what is set here later counts for models added from then on.
     *
     * <p>The structures that it hands out are its own, shared by every agent of the shape, so that looking one up costs nothing:
     * read them, and <code>clone()</code> before changing one.</p>
     */
    public final class BoundingStructuresLibrary
    {
        // by the numbers of the kinds
        private static const KINDS:Array = ["sphere", "capsule", "box"];

        /**
         * Whether the smallest sphere, box and capsule found are kept beside the tightest fit
         * (loadAllBoundingStructures, thesis §3.8).
         */
        public var keepAll:Boolean = false;

        /**
         * What is known of each shape; both libraries of a GreatLand share it.
         *
         * @private
         */
        engine var shapes:ShapeTable = new ShapeTable();

        private var _cheaperTestsFactor:Number = 1;
        private var _orientedBoxFitter:OrientedBoxFitter;
        private var _fitters:Vector.<Fitter>;

        /**
         * A library without models, with the three fitters of the thesis.
         *
         * @param orientedBoxDegIncrement degrees between the rotations that the default fitters try
         * @throws ArgumentError if that is not a positive, finite number
         */
        public function BoundingStructuresLibrary(orientedBoxDegIncrement:Number = 10)
        {
            _orientedBoxFitter = new OrientedBoxFitter(orientedBoxDegIncrement);
            _fitters = new <Fitter>[new NaiveSphereFitter(), _orientedBoxFitter, new CapsuleFitter(_orientedBoxFitter)];
        }

        /**
         * The algorithms whose results are compared when a model is added; to be changed or replaced at any time. At
         * first: the naive sphere, the oriented box, and the capsule of that box (which then is computed once).
         *
         * @throws ArgumentError if it is set to null, to an empty list or to one that has null in it
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
         * The degrees between the rotations that the oriented box of the default list tries (thesis §3.8); it does not count for other fitters.
         *
         * @throws ArgumentError if it is set to what is not a positive, finite number
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
         * How many times the smallest volume a structure may have to be preferred for its cheaper intersection tests, a sphere
         * over a capsule over a box (thesis §7.4). 1, the default, takes the smallest; of equal ones the cheapest.
         *
         * @throws ArgumentError if it is set to less than 1, or to what is not a finite number
         */
        public function get cheaperTestsFactor():Number
        {
            return _cheaperTestsFactor;
        }

        public function set cheaperTestsFactor(value:Number):void
        {
            if (!(value >= 1 && value < Infinity))
            {
                throw new ArgumentError("the factor must be 1 (off) or more: " + value);
            }
            _cheaperTestsFactor = value;
        }

        /**
         * Finds and stores the structures of a model; those stored under the name before are replaced. If it throws,
         * nothing has changed.
         *
         * @param name the shape's name
         * @param vertices x, y, z of each of the model's vertices, in the model's space; neither kept nor changed
         * @throws ArgumentError if the name is null or empty; if the vertices are null or empty, their number of coordinates is
         *         no multiple of 3, or one is not finite; if the list of fitters is empty or has one whose structures cannot be
         *         collided or do not enclose the vertices
         */
        public function add(name:String, vertices:Vector.<Number>):void
        {
            var build:StructuresBuild = newBuild(name, vertices);
            finish(build);
            shapes.of(name).structures = build.structures;
        }

        /** Whether there are structures for a shape. */
        public function has(name:String):Boolean
        {
            return shapes.of(name).structures != null;
        }

        /**
         * The tightest fit of a shape: the library's own, to be read only.
         *
         * @throws ArgumentError if no model of this name was added
         */
        public function tightestFit(name:String):BoundingStructure
        {
            return find(name).tightest;
        }

        /**
         * The smallest sphere found for a shape: the library's own, to be read only.
         *
         * @throws ArgumentError if no model of this name was added, or no sphere kept for it
         */
        public function sphere(name:String):Sphere
        {
            return Sphere(kept(name, BoundingStructure.SPHERE));
        }

        /**
         * The smallest box found for a shape: the library's own, to be read only.
         *
         * @throws ArgumentError if no model of this name was added, or no box kept for it
         */
        public function box(name:String):Box
        {
            return Box(kept(name, BoundingStructure.BOX));
        }

        /**
         * The smallest capsule found for a shape: the library's own, to be read only.
         *
         * @throws ArgumentError if no model of this name was added, or no capsule kept for it
         */
        public function capsule(name:String):Capsule
        {
            return Capsule(kept(name, BoundingStructure.CAPSULE));
        }

        /** Whether the sphere, the box and the capsule of a shape were all kept. */
        public function hasAll(name:String):Boolean
        {
            var shape:ShapeStructures = shapes.of(name).structures;
            return shape != null && shape.keepsAll && shape.smallest.indexOf(null) < 0;
        }

        /**
         * The smallest structure of a kind for a shape: the one that was kept, or else the one that the fitters find now, once.
         *
         * @param name the shape's name
         * @param kind BoundingStructure.SPHERE, CAPSULE or BOX
         * @param vertices those of the shape's model
         * @throws ArgumentError if no model of this name was added, or no fitter in the list finds this kind
         * @private
         */
        engine function ofKind(name:String, kind:int, vertices:Vector.<Number>):BoundingStructure
        {
            var shape:ShapeStructures = find(name);
            if (shape.smallest[kind] == null)
            {
                var build:StructuresBuild = new StructuresBuild(name, vertices, fitters, _cheaperTestsFactor, true);
                finish(build);
                shape.addMissing(build.structures);
            }
            if (shape.smallest[kind] == null)
            {
                throw new ArgumentError("shape \"" + name + "\" cannot be a " + KINDS[kind] + ": none of the library's fitters finds one");
            }
            return shape.smallest[kind];
        }

        /**
         * The work that finds the structures of a shape, not begun.
         *
         * @private
         */
        engine function newBuild(name:String, vertices:Vector.<Number>):StructuresBuild
        {
            ShapeTable.checkName(name);
            return new StructuresBuild(name, vertices, fitters, _cheaperTestsFactor, keepAll);
        }

        private function find(name:String):ShapeStructures
        {
            var shape:ShapeStructures = shapes.of(name).structures;
            if (shape == null)
            {
                throw ShapeTable.missing("bounding structure", name, "loadTightestFit");
            }
            return shape;
        }

        private function kept(name:String, kind:int):BoundingStructure
        {
            var shape:ShapeStructures = find(name);
            if (!shape.keepsAll || shape.smallest[kind] == null)
            {
                throw new ArgumentError("shape \"" + name + "\" has no " + KINDS[kind] + " of its own: set loadAllBoundingStructures (keepAll)"
                        + " before the model is added, and have a fitter that finds one in the list");
            }
            return shape.smallest[kind];
        }
    }
}
