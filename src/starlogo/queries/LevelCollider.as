package starlogo.queries
{
    import starlogo.collision.Collider;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.search.BaseShapeChoice;
    import starlogo.search.NarrowPhase;
    import starlogo.search.pairs.StructurePairTests;
    import starlogo.search.pairs.TreePairTests;

    use namespace engine;

    /**
     * Finds the collisions of agents that have their shapes from a LevelShapes, as a CombinationCollider finds them for a GreatLand: those of models
     * by their trees, or by their triangles if the LevelShapes is <code>exact</code>, and those of structures as they are. A game that has few other
     * needs loads less with it, because nothing is fitted.
     *
     * <listing version="3.0">
     * var shapes:LevelShapes = new LevelShapes();
     * shapes.exact = true;
     * shapes.addModel(BuiltInModel.box(20, 20, 1, "floor"));
     * shapes.addStructure("ball", new Sphere(new Vector3D(), 0.5));
     * var collision:Collision = new Collision(new LevelCollider(shapes));
     * var motions:AgentMotions = new AgentMotions(new SeenAgents(collision));
     * </listing>
     */
    public class LevelCollider extends Collider
    {
        /**
         * Creates a collider.
         *
         * @param shapes what agents collide as, with its settings. Questions and other colliders may share it
         * @throws ArgumentError if it is null
         */
        public function LevelCollider(shapes:LevelShapes)
        {
            requireGiven("shapes", shapes);
            super(shapes.choice);
        }

        /** @private */
        override engine function narrowPhaseFor(choice:BaseShapeChoice):NarrowPhase
        {
            var shared:LevelChoice = LevelChoice(choice);
            StructurePairTests.addTo(shared.narrowPhase);
            TreePairTests.addTo(shared.narrowPhase);
            return shared.narrowPhase;
        }
    }
}
