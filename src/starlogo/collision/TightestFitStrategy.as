package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.libraries.BoundingStructuresLibrary;

    use namespace engine;

    /** Every agent is the tightest fitting structure of its model, put through the agent's whole transform (thesis §3). */
    internal final class TightestFitStrategy extends ShapeStrategy
    {
        /** How two structures are tested. */
        public var tests:StructureTests = new StructureTests();

        private var _greatLand:GreatLand;

        /**
         * @param greatLand has the structures
         */
        public function TightestFitStrategy(greatLand:GreatLand)
        {
            _greatLand = greatLand;
        }

        /** @inheritDoc */
        override public function bindModel(shape:WorldShape):void
        {
            var agent:Agent = shape.agent;
            var library:BoundingStructuresLibrary = _greatLand.boundingStructures;
            if (!library.has(agent.shape))
            {
                throw new ArgumentError(agent + ": its model was added while loadTightestFit was off; set it, and add the model again");
            }
            shape.structure = library.tightestFit(agent.shape);
            shape.worldStructure = shape.structure.clone();
            shape.worldBox = shape.worldStructure as Box;
            if (shape.structure.kind == BoundingStructure.SPHERE || !library.hasAll(agent.shape))
            {
                return;
            }
            shape.outerSphere = library.sphere(agent.shape);
            shape.worldOuterSphere = shape.outerSphere.clone() as Sphere;
            shape.outerCapsule = library.capsule(agent.shape);
            shape.worldOuterCapsule = shape.outerCapsule.clone() as Capsule;
        }

        /** @inheritDoc */
        override public function updateWorldShape(shape:WorldShape):void
        {
            var placement:Placement = shape.agent.worldPlacement();
            var world:BoundingStructure = shape.structure.place(placement, shape.worldStructure);
            shape.isSphere = shape.structure.kind == BoundingStructure.SPHERE;
            if (shape.isSphere)
            {
                var sphere:Sphere = Sphere(world);
                shape.x = sphere.center.x;
                shape.y = sphere.center.y;
                shape.z = sphere.center.z;
                shape.halfX = shape.halfY = shape.halfZ = sphere.radius;
                return;
            }
            shape.takeExtentsOf(world);
            if (shape.outerSphere != null)
            {
                shape.outerSphere.place(placement, shape.worldOuterSphere);
                shape.outerCapsule.place(placement, shape.worldOuterCapsule);
            }
        }

        /** @inheritDoc */
        override public function overlaps(a:WorldShape, b:WorldShape):Boolean
        {
            return tests.overlaps(a, b);
        }

        /** @inheritDoc */
        override public function resetCounts():void
        {
            tests.resetCounts();
        }

        /** @inheritDoc */
        override public function countInto(statistics:CollisionStatistics):void
        {
            tests.countInto(statistics);
        }
    }
}
