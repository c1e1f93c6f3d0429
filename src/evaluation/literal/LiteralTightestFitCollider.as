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
            return intersect(inWorld(a), inWorld(b));
        }

        /** A transformed copy of an agent's structure. */
        public function inWorld(agent:Agent):BoundingStructure
        {
            return placed(_library.tightestFit(agent.shape), agent);
        }

        /** A copy of a structure of an agent's model, scaled, turned and moved as the agent is. */
        internal static function placed(structure:BoundingStructure, agent:Agent):BoundingStructure
        {
            var copy:BoundingStructure = structure.clone();
            var rotation:Matrix3D = new Matrix3D();
            rotation.appendRotation(agent.heading, Vector3D.Z_AXIS);
            copy.scale(agent.size);
            copy.rotate(rotation);
            copy.translate(new Vector3D(agent.x, agent.y, agent.z));
            return copy;
        }

        /** Whether two structures in the world intersect. */
        internal static function intersect(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return a is Box && b is Box ? boxBox(a as Box, b as Box) : intersects(a, b);
        }
    }
}
