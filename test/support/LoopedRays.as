package support
{
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.models.Model;

    use namespace engine;

    /** How far along a ray an agent begins, as a collision system sees it, found by RayReference in the world: with every end node, every triangle. */
    public final class LoopedRays
    {
        /** For hierarchies: how many levels are visited. */
        public var depth:int = 5;

        private var _greatLand:GreatLand;
        private var _models:Object;
        private var _corners:Vector.<Number> = new Vector.<Number>();

        /**
         * @param greatLand has the models, with boxes for nodes
         * @param models the same by their names
         */
        public function LoopedRays(greatLand:GreatLand, models:Object)
        {
            _greatLand = greatLand;
            _models = models;
        }

        /**
         * How far along the ray an agent begins.
         *
         * @param system one of EachCollider.NAMES
         * @param direction of length 1
         * @return Infinity for never; NaN if it is not clear
         */
        public function distance(system:String, agent:Agent, origin:Vector3D, direction:Vector3D):Number
        {
            switch (system)
            {
                case "bins":
                    return touch(new Sphere(new Vector3D(agent.x, agent.y, agent.z + 0.5 * agent.size), 0.5 * agent.size), agent, origin, direction);
                case "hierarchies":
                    return ofHierarchy(agent, origin, direction);
                case "triangles":
                    return isInside(agent, origin) ? 0 : ofTriangles(agent, origin, direction);
                case "combinations":
                    if (agent.hierarchical)
                    {
                        return ofHierarchy(agent, origin, direction);
                    }
            }
            return touch(TransformedStructure.of(_greatLand.boundingStructures.tightestFit(agent.shape), agent), agent, origin, direction);
        }

        private static function touch(structure:BoundingStructure, agent:Agent, origin:Vector3D, direction:Vector3D):Number
        {
            var away:Vector3D = new Vector3D(agent.x, agent.y, agent.z).subtract(origin);
            var far:Number = Math.abs(agent.x) + Math.abs(agent.y) + Math.abs(agent.z) + away.length;
            return RayReference.firstTouch(structure, origin, direction, away.length + 10 * agent.size, 1e-12 * agent.size + 1e-14 * far);
        }

        private function ofHierarchy(agent:Agent, origin:Vector3D, direction:Vector3D):Number
        {
            return isInside(agent, origin) ? 0 : ofNode(_greatLand.hierarchies.root(agent.shape), depth, agent, origin, direction);
        }

        private function ofNode(node:HierarchyNode, levels:int, agent:Agent, origin:Vector3D, direction:Vector3D):Number
        {
            // a box is around those of its children
            var at:Number = touch(TransformedStructure.of(node.bounds, agent), agent, origin, direction);
            if (at == Infinity || node.isLeaf || levels == 1)
            {
                return at;
            }
            return Math.min(ofNode(node.left, levels - 1, agent, origin, direction), ofNode(node.right, levels - 1, agent, origin, direction));
        }

        private function ofTriangles(agent:Agent, origin:Vector3D, direction:Vector3D):Number
        {
            EveryTriangle.place(agent.freshPlacement(), _models[agent.shape], _corners);
            return RayReference.firstTriangle(_corners, origin, direction);
        }

        private function isInside(agent:Agent, origin:Vector3D):Boolean
        {
            var model:Model = _models[agent.shape];
            if (!_greatLand.boundingStructures.tightestFit(agent.shape).place(agent.freshPlacement()).contains(origin))
            {
                return false;
            }
            var at:Placement = agent.freshPlacement();
            var x:Number = (origin.x - at.x) / at.size;
            var y:Number = (origin.y - at.y) / at.size;
            var z:Number = (origin.z - at.z) / at.size;
            return SolidAngles.closes(model) && Math.abs(SolidAngles.windingAround(model, at.r00 * x + at.r10 * y + at.r20 * z,
                        at.r01 * x + at.r11 * y + at.r21 * z, at.r02 * x + at.r12 * y + at.r22 * z)) > 0.5;
        }
    }
}
