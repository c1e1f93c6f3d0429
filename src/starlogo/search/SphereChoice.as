package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.search.pairs.SpherePairTests;

    use namespace engine;

    /**
     * The shape of every agent is a sphere of the agent's size, whatever its model is (thesis §2.2).
     *
     * @private
     */
    public final class SphereChoice extends BaseShapeChoice
    {
        /** @param greatLand the models that agents may have; null to allow any name */
        public function SphereChoice(greatLand:GreatLand)
        {
            super(greatLand);
            systemName = "a BinCollider";
        }

        /** @private */
        override engine function addTests(narrowPhase:NarrowPhase):void
        {
            SpherePairTests.addTo(narrowPhase);
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            shape.setStructure(new Sphere(new Vector3D(0, 0, 0.5), 0.5));
            shape.ignoresRotation = true;
        }
    }
}
