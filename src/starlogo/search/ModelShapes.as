package starlogo.search
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * The shapes of a collider's models.
     *
     * @private
     */
    public final class ModelShapes
    {
        private var _greatLand:GreatLand;
        private var _strategy:ShapeStrategy;
        private var _revision:int = -1;
        private var _shapes:Object = {};

        /**
         * @param greatLand has the models; null if the strategy needs none
         * @param strategy finds their shapes
         * @throws ArgumentError if greatLand is null, but needed
         */
        public function ModelShapes(greatLand:GreatLand, strategy:ShapeStrategy)
        {
            if (greatLand == null && strategy.needsModels)
            {
                throw new ArgumentError("greatLand must not be null");
            }
            _greatLand = greatLand;
            _strategy = strategy;
        }

        /**
         * The shape of an agent's model.
         *
         * @return null while the model is loading
         * @throws ArgumentError if the model is unknown, or what is needed of it was not loaded
         */
        public function shapeOf(agent:Agent):ModelShape
        {
            var kind:int = _strategy.kindOf(agent);
            var key:String = kind + ":" + agent.shape;
            var shape:ModelShape = _shapes[key] as ModelShape;
            if (shape != null)
            {
                return shape;
            }
            if (_greatLand != null && !_greatLand.hasModel(agent.shape))
            {
                if (_greatLand.isLoading(agent.shape))
                {
                    return null;
                }
                throw new ArgumentError(agent + ": there is no model \"" + agent.shape + "\"; add it to the GreatLand first");
            }
            shape = new ModelShape(agent.shape, kind, _greatLand == null ? 0 : _greatLand.revisionOf(agent.shape));
            _strategy.bind(shape, agent);
            _shapes[key] = shape;
            return shape;
        }

        /** Forgets the shapes of models that were replaced or removed; returns whether there were any. */
        public function forgetReplaced():Boolean
        {
            if (_greatLand == null || _greatLand.revision == _revision)
            {
                return false;
            }
            _revision = _greatLand.revision;
            var left:Object = {};
            var haveChanged:Boolean = false;
            for (var key:String in _shapes)
            {
                var shape:ModelShape = _shapes[key];
                if (shape.revision == _greatLand.revisionOf(shape.model))
                {
                    left[key] = shape;
                }
                else
                {
                    shape.isVoid = haveChanged = true;
                }
            }
            _shapes = left;
            return haveChanged;
        }
    }
}
