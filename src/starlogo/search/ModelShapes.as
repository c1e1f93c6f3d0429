package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.terrain.FixtureAgent;
    import starlogo.terrain.Terrain;

    use namespace engine;

    /**
     * Finds the shapes of the models that a collider's agents have, and keeps each shape for all agents with the model.
     *
     * @private
     */
    public final class ModelShapes
    {
        /** The forms of all shapes so far: one bit is set for each form. */
        public var forms:int = 0;

        private var _choice:ShapeChoice;
        private var _greatLand:GreatLand;
        private var _revision:int = -1;

        // The shapes that are needed often move to the front. A hash table would be slower, because each lookup would have to make a key of
        // model and kind.
        private var _shapes:Vector.<ModelShape> = new Vector.<ModelShape>();

        /** @param choice chooses the shapes */
        public function ModelShapes(choice:ShapeChoice)
        {
            _choice = choice;
            _greatLand = choice.greatLand;
        }

        /**
         * The shape of an agent's model.
         *
         * @return null while the model is loading
         * @throws ArgumentError if the model is unknown or lacks data that is needed
         */
        public function shapeOf(agent:Agent):ModelShape
        {
            if (Breeds.isReserved(agent.breedNumber))
            {
                return shapeOfFixture(agent);
            }
            var kind:int = _choice.kindOf(agent);
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
            _choice.bind(shape, agent);
            forms |= 1 << shape.form;
            _shapes.push(shape);
            return shape;
        }

        // The shape of the ground or of the edges of the world. Its structure gives the scale for tolerances: one cell, or nothing.
        private static function shapeOfFixture(agent:Agent):ModelShape
        {
            var ground:Terrain = FixtureAgent(agent).terrain;
            var half:Number = ground == null ? 0 : ground.cellWidth / 2;
            var shape:ModelShape = new ModelShape(agent.shape, Agent.ANY_KIND, 0);
            shape.structure = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, half, half, half);
            shape.form = ground == null ? ModelShape.EDGES : ModelShape.GROUND;
            shape.isUpright = true;
            return shape;
        }

        /** Forgets the shapes of models that were replaced or removed. Returns whether there were any. */
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
