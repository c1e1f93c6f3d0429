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

        // Those that are asked for often are near the beginning. A table would need keys, made of model and kind for every look.
        private var _shapes:Vector.<ModelShape> = new Vector.<ModelShape>();

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
            for (var i:int = 0; i < _shapes.length; i++)
            {
                var shape:ModelShape = _shapes[i];
                if (shape.kind == kind && shape.model == agent.shape)
                {
                    _shapes[i] = _shapes[i >> 1];
                    _shapes[i >> 1] = shape;
                    return shape;
                }
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
            _shapes.push(shape);
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
            var left:int = 0;
            var haveChanged:Boolean = false;
            for (var i:int = 0; i < _shapes.length; i++)
            {
                var shape:ModelShape = _shapes[i];
                if (shape.revision == _greatLand.revisionOf(shape.model))
                {
                    _shapes[left] = shape;
                    left++;
                }
                else
                {
                    shape.isVoid = haveChanged = true;
                }
            }
            _shapes.length = left;
            return haveChanged;
        }
    }
}
