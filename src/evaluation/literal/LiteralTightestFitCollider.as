package evaluation.literal
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.intersection.intersects;
    import starlogo.libraries.BoundingStructuresLibrary;

    /**
     * The TightestFitCollider as the thesis describes it (§3.2, §3.5, §3.6.4). For each pair of agents, both structures are copied, scaled,
     * rotated and translated. Two boxes are then tested by their eight corners on fifteen axes.
     */
    public final class LiteralTightestFitCollider
    {
        private var _library:BoundingStructuresLibrary;

        /**
         * @param library has the structures
         */
        public function LiteralTightestFitCollider(library:BoundingStructuresLibrary)
        {
            _library = library;
        }

        /** Whether two agents collide. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            var structureA:BoundingStructure = inWorld(a);
            var structureB:BoundingStructure = inWorld(b);
            if (structureA is Box && structureB is Box)
            {
                return boxBox(structureA as Box, structureB as Box);
            }
            return intersects(structureA, structureB);
        }

        /** A transformed copy of an agent's structure. */
        public function inWorld(agent:Agent):BoundingStructure
        {
            var structure:BoundingStructure = _library.tightestFit(agent.shape).clone();
            var rotation:Matrix3D = new Matrix3D();
            rotation.appendRotation(agent.heading, Vector3D.Z_AXIS);
            structure.scale(agent.size);
            structure.rotate(rotation);
            structure.translate(new Vector3D(agent.x, agent.y, agent.z));
            return structure;
        }
    }
}
