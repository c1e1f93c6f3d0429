package starlogo
{
    import flash.utils.ByteArray;
    import starlogo.data.requireGiven;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.libraries.CollisionDataBuilder;
    import starlogo.libraries.FitStore;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.libraries.ModelTable;
    import starlogo.models.Model;
    import starlogo.models.ModelReceiver;
    import starlogo.models.building.ModelData;
    import starlogo.models.cooked.CookedFile;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The models of a game, with the bounding structures and hierarchies that were computed for them. Its flags say what to compute (thesis
     * §3.8, §4.8).
     *
     * <p>A flag counts for models that are added after it was set.</p>
     *
     * <p><code>addModel()</code> adds a model at once. A ModelLoader that has this GreatLand adds models while the game runs. A game may
     * start before all models are loaded. An agent whose model is still loading collides with nothing. If two models have the same name,
     * the one that is added last replaces the other. If you call <code>addModel()</code> while another model of that name is loading, yours
     * is used until the other is loaded.</p>
     */
    public class GreatLand implements ModelReceiver
    {
        /** Whether the tightest bounding structure of a model is computed. The TightestFitCollider needs it. */
        public var loadTightestFit:Boolean = true;

        /**
         * Whether a model's hierarchy is built (§4.8). The HierarchicalCollider needs it, and the CombinationCollider for hierarchical
         * agents.
         */
        public var loadHierarchies:Boolean = true;

        /**
         * Keeps the results computed for models from one game to the next, so that they need not be computed again (thesis §7.9). Null, the
         * default, keeps nothing.
         */
        public var fitStore:FitStore = null;

        /** @private The data of all models, which both libraries share. Read only. */
        engine var models:ModelTable = new ModelTable();

        private var _boundingStructures:BoundingStructuresLibrary = new BoundingStructuresLibrary();
        private var _hierarchies:HierarchiesLibrary = new HierarchiesLibrary();

        /** Creates a GreatLand without models. */
        public function GreatLand()
        {
            _boundingStructures.models = _hierarchies.models = models;
        }

        /** The tightest bounding structure of each model. */
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
         * Whether clients may read the smallest sphere, box and capsule of a model, in addition to the tightest fit (§3.8).
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
         * Whether a convex hull of few corners is found for each model, for agents that collide as "hull". It needs loadTightestFit.
         * Without it, an agent that collides as "hull" has its model's hull computed at once when it first needs it.
         */
        public function get loadHulls():Boolean
        {
            return _boundingStructures.keepHulls;
        }

        public function set loadHulls(value:Boolean):void
        {
            _boundingStructures.keepHulls = value;
        }

        /**
         * The degrees between the rotations that the search for an oriented box tries (§3.8).
         *
         * @throws ArgumentError if you set it to a value that is less than 0.01, or not finite
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
         * Whether the surface of a model is prepared for exact tests when the model is added. A ModelLoader then does this in its steps.
         * Preparing takes two to five times as long as building the hierarchy. Otherwise the surface is prepared all at once in a frame
         * of the game. If the HierarchicalCollider or CombinationCollider is exact, this is the first frame in which the model comes
         * close to another. If the collider is not exact, this is the first frame in which the model comes close to another and the two
         * have no hit.
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
         * Adds a model, and computes the results that the flags ask for. It replaces a model of the same name. If it throws, nothing has
         * changed. Cost: the fits, tens of milliseconds for thousands of vertices.
         *
         * @param model its name is the shape's name for agents
         * @throws ArgumentError if it is null, or as <code>add</code> of BoundingStructuresLibrary and HierarchiesLibrary
         * @throws RangeError as <code>add</code> of BoundingStructuresLibrary
         */
        public function addModel(model:Model):void
        {
            finish(receive(model));
        }

        /**
         * Adds the model of a level, as <code>addModel()</code> does, but computes its hierarchy alone, whatever the flags are. An agent that has
         * this model must be hierarchical.
         *
         * @param model its name is the shape's name for agents
         * @throws ArgumentError if it is null, or as <code>add</code> of HierarchiesLibrary
         */
        public function addLevel(model:Model):void
        {
            requireGiven("model", model);
            finish(stepsOf(new CollisionDataBuilder(model, null, _hierarchies, fitStore), model));
        }

        /**
         * Returns the work of <code>addModel()</code>, in steps. For a model of some thousand vertices, a step takes a millisecond or two. A
         * fitter that does not support steps does all its work in one step. Nothing changes before the last step, or if a step throws. The
         * flags and the settings of the libraries and their fitters are read now; later changes have no effect.
         *
         * @param model its name is the shape's name for agents; it must not be posed meanwhile
         * @throws ArgumentError if it is null; in a step, if it was posed since; now or in a step, as <code>add</code> of BoundingStructuresLibrary and HierarchiesLibrary
         * @throws RangeError in a step, as <code>add</code> of BoundingStructuresLibrary
         */
        public function receive(model:Model):Steps
        {
            requireGiven("model", model);
            return stepsOf(newDataBuilder(model, fitStore), model);
        }

        // The work that computes a model's data and then keeps them.
        private function stepsOf(builder:CollisionDataBuilder, model:Model):Steps
        {
            return builder.call(function():void
                {
                    // a result that was not computed is set to null too, because the entry's old result belongs to another model
                    models.entryToWrite(model.name).replace(model, builder.structures, builder.tree);
                });
        }

        /**
         * Makes the bytes of a cooked file: the model, the results that the flags ask for, and the surface for exact colliders.
         * <code>CookedModel.fromBytes()</code> or a ModelLoader makes the model from it. The model is not added. <code>./antw cook</code>
         * does this for every file in assets/ when the game is built, so no player's machine has to compute it (thesis §7.9).
         *
         * @param model the model, as read from its file
         * @param upAxis the same as you will pass to <code>load()</code>: "x", "y", "z" or a ModelTransform
         * @param usesTransforms the loader's <code>usesTransforms</code>
         * @throws ArgumentError as addModel
         * @throws RangeError as addModel
         * @throws ModelError if the up axis is another one, or if the model's place in its source is not finite numbers, because a factor was
         *     extremely small or large
         */
        public function cook(model:Model, upAxis:Object = "z", usesTransforms:Boolean = false):ByteArray
        {
            requireGiven("model", model);
            ModelData.requireUpAxis(model.name, upAxis);
            var builder:CollisionDataBuilder = newDataBuilder(model, null);
            finish(builder);
            return builder.toCooked(CookedFile.keyOfLoad(upAxis, model.data.scaling, usesTransforms));
        }

        /** @inheritDoc */
        public function expect(name:String):void
        {
            models.entryToWrite(name).expect();
        }

        /** @inheritDoc */
        public function expectNoMore(name:String, problem:String = null):void
        {
            models.entryToWrite(name).expectNoMore(problem);
        }

        /** @private Why there is no model of a name, as the end of a message: what was wrong when its load failed, or else what to do. */
        engine function whyMissing(name:String):String
        {
            var problem:String = models.entryOf(name).loadProblem;
            return problem == null ? "; add it to the GreatLand first" : ", because its load failed: " + problem;
        }

        /** Whether a ModelLoader is loading a model of this name. A model of the same name may already be added. */
        public function isLoading(name:String):Boolean
        {
            return models.entryOf(name).isLoading;
        }

        /** Whether a model of this name was added. */
        public function hasModel(name:String):Boolean
        {
            return models.entryOf(name).model != null;
        }

        /** The model with a name, or null if no model of this name was added. */
        public function modelOf(name:String):Model
        {
            return models.entryOf(name).model;
        }

        /**
         * Removes a model and the results that were computed for it. Afterwards, collision systems throw an error if an agent still has its
         * shape. A model of this name that is still loading is added nevertheless.
         *
         * @param name the model's name
         * @return whether there was such a model
         */
        public function removeModel(name:String):Boolean
        {
            if (!hasModel(name))
            {
                return false;
            }
            models.entryToWrite(name).replace(null, null, null);
            return true;
        }

        /** @private Increased whenever data of any model is replaced, removed or posed. Results derived from the data are then out of date. */
        engine function get revision():int
        {
            return models.revision;
        }

        /** @private The revision of one model. */
        engine function revisionOf(name:String):int
        {
            return models.entryOf(name).revision;
        }

        /** The names of all models that were added, in no order: a new list. */
        public function get modelNames():Vector.<String>
        {
            return models.names.filter(function(name:String, index:int, all:Vector.<String>):Boolean
                {
                    return hasModel(name);
                });
        }

        /** @private The work that builds the collision data that the flags ask for. None of its steps is done yet. @param store null for none */
        engine function newDataBuilder(model:Model, store:FitStore):CollisionDataBuilder
        {
            return new CollisionDataBuilder(model, loadTightestFit ? _boundingStructures : null, loadHierarchies ? _hierarchies : null, store);
        }
    }
}
