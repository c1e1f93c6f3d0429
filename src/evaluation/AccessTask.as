package evaluation
{
    import evaluation.literal.LiteralTightestFitCollider;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;

    use namespace engine;

    /** Figure 6-3: the time to look up and place the tightest fit of an agent that has moved and turned. */
    public final class AccessTask extends MeasuringTask
    {
        private static const COUNT:int = 500;

        private var _greatLand:GreatLand;
        private var _agent:Agent;
        private var _placed:BoundingStructure;
        private var _literalCollider:LiteralTightestFitCollider;
        private var _ours:Measurement;
        private var _literal:Measurement;

        /**
         * @param shape the agent's shape
         * @param greatLand has its tightest fit
         * @param settings says how often
         * @param results takes the times
         */
        public function AccessTask(shape:String, greatLand:GreatLand, settings:Settings, results:Results)
        {
            super("access and transform of the " + shape, settings.repetitions * 100, settings, results);
            _greatLand = greatLand;
            _agent = new Agent(shape);
        }

        /** @inheritDoc */
        override protected function prepare():void
        {
            _placed = _greatLand.boundingStructures.tightestFit(_agent.shape).clone();
            _literalCollider = new LiteralTightestFitCollider(_greatLand.boundingStructures);
            _ours = measure("place", place, COUNT);
            _literal = measure("literal place", placeLiterally, COUNT);
        }

        /** @inheritDoc */
        override protected function conclude():Boolean
        {
            _results.addTime("access", _agent.shape, "engine", _ours, _base, Thesis.ACCESS_MS[_agent.shape]);
            _results.addTime("access", _agent.shape, "literal", _literal, _base);
            return true;
        }

        private function place():void
        {
            for (var i:int = 0; i < COUNT; i++)
            {
                _agent.moveTo(i, 1, 0);
                _agent.heading = i;
                _greatLand.boundingStructures.tightestFit(_agent.shape).place(_agent.freshPlacement(), _placed);
            }
        }

        private function placeLiterally():void
        {
            for (var i:int = 0; i < COUNT; i++)
            {
                _agent.moveTo(i, 1, 0);
                _agent.heading = i;
                _literalCollider.inWorld(_agent);
            }
        }
    }
}
