package support
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.intersects;

    use namespace engine;

    /**
     * What a traversal has to find, without one: every node at which a hierarchy ends, put into the world, against every one
     * of the other.
     */
    public final class HierarchyReference
    {
        private var _greatLand:GreatLand;

        /**
         * @param greatLand has the models
         */
        public function HierarchyReference(greatLand:GreatLand)
        {
            _greatLand = greatLand;
        }

        /** Whether two agents' hierarchies meet, visited to these depths. */
        public function areColliding(a:Agent, depthA:int, b:Agent, depthB:int):Boolean
        {
            return doMeet(endsOf(a, depthA), endsOf(b, depthB));
        }

        private static function doMeet(a:Vector.<BoundingStructure>, b:Vector.<BoundingStructure>):Boolean
        {
            for (var i:int = 0; i < a.length; i++)
            {
                for (var j:int = 0; j < b.length; j++)
                {
                    if (intersects(a[i], b[j]))
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        /** The nodes at which an agent's hierarchy ends, visited to a depth, in the world. */
        public function endsOf(agent:Agent, depth:int):Vector.<BoundingStructure>
        {
            var ends:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
            collect(agent, _greatLand.hierarchies.root(agent.shape), depth, ends);
            return ends;
        }

        private static function collect(agent:Agent, node:HierarchyNode, depth:int, out:Vector.<BoundingStructure>):void
        {
            if (node.isLeaf || depth == 1)
            {
                out.push(node.bounds.place(agent.freshPlacement()));
                return;
            }
            collect(agent, node.left, depth - 1, out);
            collect(agent, node.right, depth - 1, out);
        }
    }
}
