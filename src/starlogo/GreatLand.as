package starlogo
{
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.libraries.FitSettings;
    import starlogo.libraries.FitStore;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.libraries.ModelBuild;
    import starlogo.libraries.ShapeEntry;
    import starlogo.libraries.ShapeTable;
    import starlogo.libraries.StructuresBuild;
    import starlogo.models.Model;
    import starlogo.models.ModelReceiver;
    import starlogo.models.cooked.argumentsFingerprint;
    import starlogo.solid.SolidHierarchyBuilder;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * What a game has loaded, and how it is loaded: the flags of the thesis (§3.8, §4.8), its models, and what was
     * computed for them.
     *
     * <p>The flags count for the models that are added from then on.</p>
     *
     * <p>Models are added at once, by <code>addModel()</code>, or while the game runs, by a ModelLoader that is given this
     * GreatLand. A game may start with the models that are there; an agent whose model is still loading
     * collides with nothing until then. If two models of a name are added, the one that is there last replaces the other:
     * one that <code>addModel()</code> adds while another is loading serves until then.</p>
     */
    public class GreatLand implements ModelReceiver
    {
        /** Whether a model's tightest fitting structure is computed: the TightestFitCollider needs it. */
        public var loadTightestFit:Boolean = true;

        /**
         * Whether a model's hierarchy is built: the HierarchicalCollider needs it, and the CombinationCollider for the
         * agents that are hierarchical (§4.8).
         */
        public var loadHierarchies:Boolean = true;

        /**
         * Keeps what was computed for models from one game to the next, so that it need not be computed again (thesis §7.9); null, the
         * default, for nothing of the kind.
         */
        public var fitStore:FitStore = null;

        // shared with the libraries
        private var _shapes:ShapeTable = new ShapeTable();
        private var _boundingStructures:BoundingStructuresLibrary = new BoundingStructuresLibrary();
        private var _hierarchies:HierarchiesLibrary = new HierarchiesLibrary();

        /** A game without models. */
        public function GreatLand()
        {
            _boundingStructures.shapes = _hierarchies.shapes = _shapes;
        }

        /** The tightest fitting structure of each model. */
        public function get boundingStructures():BoundingStructuresLibrary
        {
            return _boundingStructures;
        }

        /** The hierarchy of each model. */
        public function get hierarchies():HierarchiesLibrary
        {
            return _hierarchies;
        }

        /**
         * Whether the best sphere, box and capsule of a model are kept, and not just the tightest fit (§3.8). With all
         * of them at hand, the TightestFitCollider tries spheres before boxes (§7.5).
         */
        public function get loadAllBoundingStructures():Boolean
        {
            return _boundingStructures.keepAll;
        }

        public function set loadAllBoundingStructures(value:Boolean):void
        {
            _boundingStructures.keepAll = value;
        }

        /**
         * The degrees between the rotations that the search for an oriented box tries (§3.8).
         *
         * @throws ArgumentError if it is set to what is not a positive, finite number
         */
        public function get orientedBoxDegIncrement():Number
        {
            return _boundingStructures.orientedBoxDegIncrement;
        }

        public function set orientedBoxDegIncrement(value:Number):void
        {
            _boundingStructures.orientedBoxDegIncrement = value;
        }

        /**
         * How many times the smallest volume a tightest fit may have to be one with cheaper intersection tests, a sphere over a
         * capsule over a box (thesis §7.4). 1, the default, takes the smallest.
         *
         * @throws ArgumentError if it is set to less than 1, or to what is not a finite number
         */
        public function get cheaperTestsFactor():Number
        {
            return _boundingStructures.cheaperTestsFactor;
        }

        public function set cheaperTestsFactor(value:Number):void
        {
            _boundingStructures.cheaperTestsFactor = value;
        }

        /**
         * Which structures the nodes of hierarchies have (thesis §7.7): BoundingStructure.BOX, the default, SPHERE or CAPSULE. Boxes
         * are the fastest by far.
         *
         * @throws ArgumentError if it is set to anything else
         */
        public function get hierarchyBounds():int
        {
            return _hierarchies.boundsKind;
        }

        public function set hierarchyBounds(value:int):void
        {
            _hierarchies.boundsKind = value;
        }

        /**
         * Whether what the HierarchicalCollider and the CombinationCollider need beyond boxes is prepared when a model is added, by a
         * ModelLoader in its steps, and not at once when it is first needed: in exact mode when the model first comes close to
         * another, otherwise when it first does so without a hit. It takes two to five times as long as the hierarchy.
         */
        public function get prepareExact():Boolean
        {
            return _hierarchies.prepareExact;
        }

        public function set prepareExact(value:Boolean):void
        {
            _hierarchies.prepareExact = value;
        }

        /**
         * Adds a model, and what the flags ask for; replaces the model of its name, if there is one. When it throws,
         * nothing has changed. Cost: that of the fits, up to a few hundred milliseconds for thousands of vertices.
         *
         * @param model has the name that agents have as their shape
         * @throws ArgumentError if it is null, or as the add of BoundingStructuresLibrary and HierarchiesLibrary do
         */
        public function addModel(model:Model):void
        {
            finish(receive(model));
        }

        /**
         * Does what <code>addModel()</code> does in steps of a millisecond or two, as far as a model of some thousand vertices
         * goes; a fitter that does not know of steps takes all of its time in one. Nothing changes before the last step, nor if
         * one throws. The flags, and the settings of the libraries and their fitters, count as they are now.
         *
         * @param model has the name that agents have as their shape; not to be changed meanwhile
         * @throws ArgumentError if it is null; here or in a step, as the add of BoundingStructuresLibrary and
         *         HierarchiesLibrary do
         */
        public function receive(model:Model):Steps
        {
            var build:ModelBuild = newBuild(model, fitStore);
            return new StepSequence().add(build).call(function():void
                {
                    // null where there is none: what the name had before is another model's
                    var shape:ShapeEntry = _shapes.of(model.name);
                    shape.setHierarchy(build.hierarchy);
                    shape.structures = build.structures;
                    shape.model = model;
                });
        }

        /**
         * Computes what the flags ask for of a model, and what exact colliders need besides, and writes it down with the model: the bytes of a
         * cooked file, of which <code>CookedModel.fromBytes()</code> or a ModelLoader makes the model again. The model is not
         * added. <code>./antw bake</code> does this for every file in assets/ when the game is built, so that no player's machine ever
         * has to (thesis §7.9).
         *
         * @param model the model, as it is read from its file
         * @param upAxis what <code>load()</code> will be given: "x", "y", "z" or a ModelTransform
         * @param usesTransforms whether the loader will ask for transform files beside models
         * @throws ArgumentError as addModel does
         * @throws RangeError as addModel does
         */
        public function bake(model:Model, upAxis:Object = "z", usesTransforms:Boolean = false):ByteArray
        {
            var build:ModelBuild = newBuild(model, null);
            finish(build);
            return build.toCooked(argumentsFingerprint(upAxis, model.source.scaling, usesTransforms));
        }

        /** @inheritDoc */
        public function expect(name:String):void
        {
            _shapes.of(name).loading++;
        }

        /** @inheritDoc */
        public function expectNoMore(name:String):void
        {
            _shapes.of(name).loading--;
        }

        /** Whether a ModelLoader is loading a model of this name, be there another one of the name or not. */
        public function isLoading(name:String):Boolean
        {
            return _shapes.of(name).loading > 0;
        }

        /** Whether a model of this name was added. */
        public function hasModel(name:String):Boolean
        {
            return _shapes.of(name).model != null;
        }

        /**
         * Takes a model away, and what was computed for it. An agent that still has its shape is an error of the collision
         * systems from then on. One that is loading under the name comes all the same.
         *
         * @param name the model's name
         * @return whether it was there
         */
        public function removeModel(name:String):Boolean
        {
            if (!hasModel(name))
            {
                return false;
            }
            var shape:ShapeEntry = _shapes.of(name);
            shape.model = null;
            shape.setHierarchy(null);
            shape.structures = null;
            return true;
        }

        /** @private Increased whenever what is known of any model is replaced or removed: what was made of it is out of date. */
        engine function get revision():int
        {
            return _shapes.revision;
        }

        /** @private The revision of one model alone. */
        engine function revisionOf(name:String):int
        {
            return _shapes.of(name).revision;
        }

        /**
         * The smallest structure of a kind around a model, computed now if it was not kept.
         *
         * @param name the name of a model that was added
         * @param kind BoundingStructure.SPHERE, CAPSULE or BOX
         * @throws ArgumentError if its structures were not loaded, or no fitter finds this kind
         * @private
         */
        engine function structureOfKind(name:String, kind:int):BoundingStructure
        {
            return _boundingStructures.ofKind(name, kind, _shapes.of(name).model.vertices);
        }

        /** @private The model of a name; null if there is none. */
        engine function modelOf(name:String):Model
        {
            return _shapes.of(name).model;
        }

        /** @private The work that computes what the flags ask for of a model; not begun. What it finds is not added. */
        engine function newBuild(model:Model, fitStore:FitStore):ModelBuild
        {
            if (model == null)
            {
                throw new ArgumentError("model must not be null");
            }
            var settings:FitSettings = new FitSettings(loadTightestFit ? _boundingStructures : null, loadHierarchies ? _hierarchies : null);
            var hierarchy:SolidHierarchyBuilder = loadHierarchies ? _hierarchies.newBuilderOf(model) : null;
            var structures:StructuresBuild = loadTightestFit ? _boundingStructures.newBuild(model.name, model.vertices) : null;
            return new ModelBuild(model, structures, hierarchy, settings, fitStore);
        }
    }
}
