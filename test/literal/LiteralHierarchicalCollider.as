package literal
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;

    /**
     * The HierarchicalCollider as the thesis describes it (§4.6, §6.3.3): for each pair of nodes, both boxes are copied and
     * transformed and tested by eight corners on fifteen axes, depth-first down to two leaves or the fifth level.
     */
    public final class LiteralHierarchicalCollider
    {
        private static const MAX_DEPTH:int = 5;

        private var _roots:Object = {};

        /** Builds the hierarchy of a shape. */
        public function add(shape:String, vertices:Vector.<Number>):void
        {
            _roots[shape] = LiteralHierarchyNode.of(vertices);
        }

        /** Whether two agents collide. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            return doNodesMeet(a, _roots[a.shape], b, _roots[b.shape], 1);
        }

        private function doNodesMeet(a:Agent, nodeA:LiteralHierarchyNode, b:Agent, nodeB:LiteralHierarchyNode, level:int):Boolean
        {
            if (!boxBox(inWorld(a, nodeA), inWorld(b, nodeB)))
            {
                return false;
            }
            if (level == MAX_DEPTH || (nodeA.isLeaf && nodeB.isLeaf))
            {
                return true;
            }
            for each (var childA:LiteralHierarchyNode in nodeA.isLeaf ? [nodeA] : [nodeA.left, nodeA.right])
            {
                for each (var childB:LiteralHierarchyNode in nodeB.isLeaf ? [nodeB] : [nodeB.left, nodeB.right])
                {
                    if (doNodesMeet(a, childA, b, childB, level + 1))
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        private static function inWorld(agent:Agent, node:LiteralHierarchyNode):Box
        {
            var box:Box = node.box.clone() as Box;
            var rotation:Matrix3D = new Matrix3D();
            rotation.appendRotation(agent.heading, Vector3D.Z_AXIS);
            box.scale(agent.size);
            box.rotate(rotation);
            box.translate(new Vector3D(agent.x, agent.y, agent.z));
            return box;
        }
    }
}
