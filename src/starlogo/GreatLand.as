package starlogo
{
    import starlogo.agents.Agent;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.libraries.Hierarchy;
    import starlogo.models.Model;

    use namespace engine;

    /**
     * What a game has loaded, and how it is to be loaded: the flags of the thesis (§3.8, §4.8), its models, and what was
     * computed for them.
     *
     * <p>The flags count for the models that are added from then on.</p>
     */
    public class GreatLand
    {
        // in front of every key: a model may be called "hasOwnProperty"
        private static const PREFIX:String = ":";

        /** Whether a model's tightest fitting structure is computed: the TightestFitCollider needs it. */
        public var loadTightestFit:Boolean = true;

        /**
         * Whether a model's hierarchy is built: the HierarchicalCollider needs it, and the CombinationCollider for the
         * agents that are hierarchical (§4.8).
         */
        public var loadHierarchies:Boolean = true;

        /** Counts the models that replaced another one of their name: what was kept of those is void. */
        engine var edition:int = 0;

        private var _models:Object = {};
        private var _boundingStructures:BoundingStructuresLibrary = new BoundingStructuresLibrary();
        private var _hierarchies:HierarchiesLibrary = new HierarchiesLibrary();

        /** A game without models. */
        public function GreatLand()
        {
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
         * Adds a model, and what the flags ask for; replaces the model of its name, if there is one. When it throws,
         * nothing has changed. Cost: that of the fits, up to a few hundred milliseconds for thousands of vertices.
         *
         * @param model has the name that agents have as their shape
         * @throws ArgumentError if it is null, or as the add of BoundingStructuresLibrary and HierarchiesLibrary do
         * @throws RangeError as HierarchiesLibrary.add does
         */
        public function addModel(model:Model):void
        {
            if (model == null)
            {
                throw new ArgumentError("model must not be null");
            }
            // built first, stored last: what fails leaves nothing behind
            var hierarchy:Hierarchy = null;
            if (loadHierarchies)
            {
                hierarchy = _hierarchies.build(model.name, model.vertices, model.triangles);
            }
            if (loadTightestFit)
            {
                _boundingStructures.add(model.name, model.vertices);
            }
            // null where there is none: one that the name had before is another model's
            _hierarchies.store(model.name, hierarchy);
            if (hasModel(model.name))
            {
                edition++;
            }
            _models[PREFIX + model.name] = model;
        }

        /** Whether a model of this name was added. */
        public function hasModel(name:String):Boolean
        {
            return _models.hasOwnProperty(PREFIX + name);
        }

        /** Throws an ArgumentError if the agent's model was not added. */
        engine function requireModel(agent:Agent):void
        {
            if (!hasModel(agent.shape))
            {
                throw new ArgumentError(agent + ": there is no model \"" + agent.shape + "\"; add it to the GreatLand first");
            }
        }
    }
}
