// A choice decides what agents collide as: the shape of each model, in each collider. SphereChoice, TightestFitChoice and TreeChoice are those of the
// engine's colliders, LevelChoice (in the room queries) that of a level, and games extend ShapeChoice. Each says in bind() which shape a model gets,
// and in variantOf() which of a model's shapes an agent gets. What all have is here: the shapes that were bound, until their models change.
package starlogo.search
{
    import flash.errors.IllegalOperationError;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.data.IntPairMap;
    import starlogo.data.hintOfName;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.requireInWorld;
    import starlogo.models.Model;

    use namespace engine;

    /**
     * Chooses the shape of each agent's model for a Collider, and keeps it for all agents with the model. Each of the engine's colliders has a
     * subclass of its own. Games extend ShapeChoice.
     */
    public class BaseShapeChoice
    {
        /** The models, or null if the shapes need no models. */
        public var greatLand:GreatLand;

        /** @private What errors call a collision system with such shapes. Snapshots have its index in <code>Snapshots.SYSTEMS</code>. */
        engine var systemName:String = "a collider of the game's own";

        /** @private Whether all shapes so far are spheres. */
        engine var areSpheres:Boolean = true;

        /** @private Whether <code>bind()</code> runs. Read only. */
        engine var isBinding:Boolean = false;

        // The shapes that are not stale.
        private var _shapes:Vector.<ModelShape> = new Vector.<ModelShape>();

        // By the number of the model's name and the variant: the index of the shape.
        private var _indices:IntPairMap = new IntPairMap();

        // The revision of all models at which stale shapes were forgotten.
        private var _seenRevision:int = -1;

        /**
         * For subclasses only.
         *
         * @param greatLand the models; null if the shapes need no models
         */
        public function BaseShapeChoice(greatLand:GreatLand)
        {
            this.greatLand = greatLand;
        }

        /**
         * @private Gives a collider's narrow phase the tests of pairs of the shapes. A game loads only the code of these tests. Shapes that only
         * questions see have none, because each kind of questions brings its own (SeenAgents.needTests).
         *
         * @throws ArgumentError if these shapes have none
         */
        engine function addTests(narrowPhase:NarrowPhase):void
        {
            throw new ArgumentError("a Collider needs a ShapeChoice, not " + this + ", which gives no tests of its shapes");
        }

        /** @private Increased whenever data of any model is replaced, removed or posed. Shapes made from the data are then stale. */
        engine function get revision():int
        {
            return greatLand == null ? 0 : greatLand.revision;
        }

        /** @private The revision of one model. */
        engine function revisionOf(name:String):int
        {
            return greatLand == null ? 0 : greatLand.revisionOf(name);
        }

        /** @private The model with a name; null if there is none, or if the shapes need no models. */
        engine function modelOf(name:String):Model
        {
            return greatLand == null ? null : greatLand.modelOf(name);
        }

        /** @private Whether the model of an agent is still loading. Throws an ArgumentError if the model is unknown. */
        engine function isLoading(agent:Agent):Boolean
        {
            if (greatLand == null || greatLand.hasModel(agent.shape))
            {
                return false;
            }
            if (!greatLand.isLoading(agent.shape))
            {
                throw new ArgumentError(agent + ": there is no model \"" + agent.shape + "\"" + greatLand.whyMissing(agent.shape)
                        + hintOfName(agent.shape, greatLand.modelNames, agent.breed));
            }
            return true;
        }

        /**
         * The number of an agent's shape among the shapes that its model can have. Agents with the same model and the same number share a shape.
         * The number may depend on the traits <code>hierarchical</code> and <code>collideAs</code>.
         *
         * @param agent not null
         */
        public function variantOf(agent:Agent):int
        {
            return ModelShape.ONLY_VARIANT;
        }

        /**
         * Sets the shape of a model. All agents with the same model and variant use it. While it runs, the collider refuses to search, and to
         * answer about agents whose models have no shapes yet. It must not change the list of agents.
         *
         * @param shape has the model's name and the variant. Call its setStructure()
         * @param agent an agent with the model; the model is in the GreatLand
         * @throws ArgumentError if the shape needs something that was not loaded
         */
        public function bind(shape:ModelShape, agent:Agent):void
        {
            throw new IllegalOperationError(this + " does not implement bind");
        }

        /**
         * @private The shape of an agent's model. All agents with the model and the same variant share it.
         *
         * @return null while the model is loading
         * @throws ArgumentError if the model is unknown or lacks data that is needed, or if <code>bind()</code> gives it no shape
         * @throws IllegalOperationError if the model has no shape yet, and <code>bind()</code> of another one runs
         * @throws RangeError if its structure is not in the world
         */
        engine function shapeOf(agent:Agent):ModelShape
        {
            var variant:int = variantOf(agent);
            var index:int = _indices.find(agent.modelNumber, variant);
            return index < 0 ? newShape(agent, variant) : _shapes[index];
        }

        private function newShape(agent:Agent, variant:int):ModelShape
        {
            if (isLoading(agent))
            {
                return null;
            }
            var shape:ModelShape = new ModelShape(agent.shape, variant, revisionOf(agent.shape));
            shape.model = modelOf(agent.shape);
            if (isBinding)
            {
                throw new IllegalOperationError("bind() must not ask about " + agent + ", whose model has no shape yet");
            }
            isBinding = true;
            try
            {
                bind(shape, agent);
            }
            finally
            {
                isBinding = false;
            }
            if (shape.kind < 0)
            {
                throw new ArgumentError(agent + ": its model has no shape, because bind() of the shape choice has not called setStructure()");
            }
            requireExtents(shape, agent);
            areSpheres = areSpheres && shape.kind == BoundingStructure.SPHERE;
            _indices.set (agent.modelNumber, variant, _shapes.push(shape) - 1);
            return shape;
        }

        // A game's own choice, and a model as it was given, may be anywhere.
        private static function requireExtents(shape:ModelShape, agent:Agent):void
        {
            var extents:Vector.<Number> = new Vector.<Number>(6, true);
            shape.structure.findPlacedBox(Placement.IDENTITY, extents);
            requireInWorld("the middle of its model's structure", extents[0], extents[1], extents[2], agent);
            requireInWorld("half of the length of its model's structure", extents[3], extents[4], extents[5], agent);
        }

        /** @private Forgets the shapes of models that were replaced, removed or posed. They are stale then. */
        engine function forgetReplaced():void
        {
            if (revision == _seenRevision)
            {
                return;
            }
            _seenRevision = revision;
            var kept:int = 0;
            _indices.clear();
            for (var i:int = 0; i < _shapes.length; i++)
            {
                var shape:ModelShape = _shapes[i];
                shape.isStale = shape.revision != revisionOf(shape.modelName);
                if (!shape.isStale)
                {
                    _indices.set (Agent.MODEL_NAMES.numberOf(shape.modelName), shape.variant, kept);
                    _shapes[kept] = shape;
                    kept++;
                }
            }
            _shapes.length = kept;
        }
    }
}
