package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.requireInWorld;

    use namespace engine;

    /**
     * Finds the shapes of the models that a collider's agents have, and keeps each shape for all agents with the model.
     *
     * @private
     */
    public final class ModelShapes
    {
        /** Whether all shapes so far are spheres. */
        public var areSpheres:Boolean = true;

        private var _choice:BaseShapeChoice;
        private var _revision:int = -1;

        // A text stands before each key, because a model may be called "hasOwnProperty".
        private static const PREFIX:String = ":";
        private static const MOST_RECENT:int = 8;

        // The shapes of each model, by its name, as a chain. _recent has a few shapes that were needed last: finding one there needs no key. A
        // shape that is found there moves towards the front.
        private var _ofModels:Object = {};
        private var _recent:Vector.<ModelShape> = new Vector.<ModelShape>();

        /**
         * @param choice chooses the shapes
         */
        public function ModelShapes(choice:BaseShapeChoice)
        {
            _choice = choice;
        }

        /**
         * The shape of an agent's model, or the ground or the edges of the world as they are now.
         *
         * @return null while the model is loading
         * @throws ArgumentError if the model is unknown or lacks data that is needed, if the choice gives it no shape, or if the ground or the
         *     edges are not known
         * @throws RangeError if its structure is not in the world
         */
        public function shapeOf(agent:Agent):ModelShape
        {
            if (agent.isOfWorld)
            {
                return shapeOfWorldAgent(WorldAgent(agent));
            }
            var kind:int = _choice.kindOf(agent);
            for (var i:int = 0; i < _recent.length; i++)
            {
                var shape:ModelShape = _recent[i];
                if (shape.kind == kind && shape.modelName == agent.shape)
                {
                    _recent[i] = _recent[i >> 1];
                    _recent[i >> 1] = shape;
                    return shape;
                }
            }
            shape = _ofModels[PREFIX + agent.shape];
            while (shape != null && shape.kind != kind)
            {
                shape = shape.next;
            }
            shape ||= newShape(agent, kind);
            if (shape != null)
            {
                _recent[Math.min(_recent.length, MOST_RECENT - 1)] = shape;
            }
            return shape;
        }

        private function newShape(agent:Agent, kind:int):ModelShape
        {
            if (_choice.isLoading(agent))
            {
                return null;
            }
            var shape:ModelShape = new ModelShape(agent.shape, kind, _choice.revisionOf(agent.shape));
            shape.model = _choice.modelOf(agent.shape);
            _choice.bind(shape, agent);
            if (shape.form < 0)
            {
                throw new ArgumentError(agent + ": its model has no shape, because bind() of the shape choice has not called setStructure()");
            }
            requireExtents(shape, agent);
            areSpheres = areSpheres && shape.form == BoundingStructure.SPHERE;
            shape.next = _ofModels[PREFIX + shape.modelName];
            _ofModels[PREFIX + shape.modelName] = shape;
            return shape;
        }

        // A game's own choice, and a model as it was given, may be anywhere.
        private static function requireExtents(shape:ModelShape, agent:Agent):void
        {
            var extents:Vector.<Number> = new Vector.<Number>(6, true);
            shape.structure.rotatedBoxInto(new Placement(), extents);
            requireInWorld(agent + ": the middle of its model's structure", extents[0], extents[1], extents[2]);
            requireInWorld(agent + ": half of the length of its model's structure", extents[3], extents[4], extents[5]);
        }

        private static function shapeOfWorldAgent(agent:WorldAgent):ModelShape
        {
            if (agent.surface == null)
            {
                throw new ArgumentError("the place of " + agent + " is not known: it was exchanged before another Collision wrote the snapshot");
            }
            return agent.surface;
        }

        /** Forgets the shapes of models that were replaced or removed. Returns whether there were any. */
        public function forgetReplaced():Boolean
        {
            if (_choice.revision == _revision)
            {
                return false;
            }
            _revision = _choice.revision;
            var haveChanged:Boolean = false;
            for (var key:String in _ofModels)
            {
                var shape:ModelShape = _ofModels[key];
                if (shape.revision != _choice.revisionOf(shape.modelName))
                {
                    delete _ofModels[key];
                    haveChanged = true;
                    for (; shape != null; shape = shape.next)
                    {
                        shape.isVoid = true;
                    }
                }
            }
            if (haveChanged)
            {
                _recent.length = 0;
            }
            return haveChanged;
        }
    }
}
