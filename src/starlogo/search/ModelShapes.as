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
        private static const RECENT:int = 8;

        private var _greatLand:GreatLand;
        private var _strategy:ShapeStrategy;
        private var _revision:int = -1;
        private var _shapes:Object = {};

        // Some of these, found without a key, which would have to be made.
        private var _recent:Vector.<ModelShape> = new Vector.<ModelShape>();
        private var _next:int = 0;

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
            for (var i:int = 0; i < _recent.length; i++)
            {
                if (_recent[i].kind == kind && _recent[i].model == agent.shape)
                {
                    return _recent[i];
                }
            }
            var key:String = kind + ":" + agent.shape;
            var shape:ModelShape = _shapes[key] as ModelShape;
            if (shape != null)
            {
                keep(shape);
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
            _recent.length = _next = 0;
            return haveChanged;
        }

        // In place of the one that has been there for the longest time.
        private function keep(shape:ModelShape):void
        {
            _recent[_next] = shape;
            _next = (_next + 1) % RECENT;
        }
    }
}
