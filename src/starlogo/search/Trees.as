package starlogo.search
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.requireGiven;

    use namespace engine;

    /**
     * The shape of every agent is its model's hierarchy (thesis §4).
     *
     * @private
     */
    public class Trees extends AgentShapes
    {
        /** @param greatLand the models' hierarchies */
        public function Trees(greatLand:GreatLand)
        {
            super(greatLand);
            requireGiven("greatLand", greatLand);
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            if (!greatLand.hierarchies.has(shape.model))
            {
                throw new ArgumentError(agent + ": its model was added while loadHierarchies was false; set it to true, and add the model again");
            }
            shape.setTree(greatLand.hierarchies.hierarchy(shape.model));
        }
    }
}
