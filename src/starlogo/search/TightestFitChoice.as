package starlogo.search
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.data.warn;
    import starlogo.engine;
    import starlogo.libraries.BoundingStructuresLibrary;

    use namespace engine;

    /**
     * The shape of every agent is its model's tightest fit, or the structure that its trait <code>collideAs</code> names (thesis §7.3). The
     * agent's rotation and size apply to it (thesis §3).
     *
     * @private
     */
    public final class TightestFitChoice extends ShapeChoice
    {
        // A model of more triangles is probably a level.
        private static const MAX_TRIANGLES:int = 10000;

        /** @param greatLand the models' structures */
        public function TightestFitChoice(greatLand:GreatLand)
        {
            super(greatLand);
            systemName = "a TightestFitCollider";
        }

        /** The kind of structure that the agent has chosen, or Agent.ANY_KIND. @inheritDoc */
        override public function variantOf(agent:Agent):int
        {
            return agent.structureKind;
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            var library:BoundingStructuresLibrary = greatLand.boundingStructures;
            var model:String = shape.modelName;
            if (!library.has(model))
            {
                throw new ArgumentError(agent + ": its model was added by addLevel() or while loadTightestFit was false. For a level set hierarchical of the agent, in a CombinationCollider; "
                        + "for another model set loadTightestFit to true, and add it again by addModel()");
            }
            if (shape.variant != Agent.ANY_KIND)
            {
                shape.setStructure(library.findOrFit(model, shape.variant));
                return;
            }
            shape.setStructure(library.tightestFit(model));
            warnOfLevel(model, agent);
        }

        // A level is one large model, and a structure around it is hardly what a game wants.
        private function warnOfLevel(model:String, agent:Agent):void
        {
            var triangles:Vector.<uint> = greatLand.modelOf(model).triangles;
            if (triangles != null && triangles.length > 3 * MAX_TRIANGLES)
            {
                warn(agent + " has " + triangles.length / 3 + " triangles, and collides as the structure around them: for a level set hierarchical to true in a "
                        + "CombinationCollider; for a figure choose a structure with collideAs");
            }
        }
    }
}
