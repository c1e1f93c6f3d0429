package support
{
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.StructurePairs;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * How far agents are apart, without leaving anything out: every node at which a hierarchy ends, or every triangle, put into the world, from
     * every one of the other. The distances of two of these have tests of their own.
     */
    public final class DistanceReference
    {
        private var _greatLand:GreatLand;
        private var _hierarchies:HierarchyReference;
        private var _pair:ClosestPoints = new ClosestPoints();

        /**
         * @param greatLand has the models
         */
        public function DistanceReference(greatLand:GreatLand)
        {
            _greatLand = greatLand;
            _hierarchies = new HierarchyReference(greatLand);
        }

        /** Of hierarchies, visited to these depths. */
        public function ofNodes(a:Agent, depthA:int, b:Agent, depthB:int):Number
        {
            return least(_hierarchies.endsOf(a, depthA), _hierarchies.endsOf(b, depthB));
        }

        /** Of surfaces. */
        public function ofTriangles(a:Agent, b:Agent):Number
        {
            var distance:Number = Infinity;
            var cornersA:Vector.<Number> = cornersOf(a, b);
            var cornersB:Vector.<Number> = cornersOf(b, b);
            for (var i:int = 0; i < cornersA.length; i += 9)
            {
                for (var k:int = 0; k < cornersB.length; k += 9)
                {
                    distance = Math.min(distance, PlainDistance.ofTriangles(cornersA, i, cornersB, k));
                }
            }
            return distance;
        }

        /** Of a point and an agent's hierarchy. */
        public function fromNodes(agent:Agent, depth:int, point:Vector3D):Number
        {
            return least(_hierarchies.endsOf(agent, depth), new <BoundingStructure>[new Sphere(point, 0)]);
        }

        /** Of a point and an agent's surface. */
        public function fromTriangles(agent:Agent, point:Vector3D):Number
        {
            var distance:Number = Infinity;
            var corners:Vector.<Number> = cornersOf(agent, agent);
            var x:Number = point.x - agent.x;
            var y:Number = point.y - agent.y;
            var z:Number = point.z - agent.z;
            var points:Vector.<Number> = new <Number>[x, y, z, x, y, z, x, y, z];
            for (var i:int = 0; i < corners.length; i += 9)
            {
                distance = Math.min(distance, PlainDistance.ofTriangles(corners, i, points, 0));
            }
            return distance;
        }

        // Relative to another agent's place, to be as precise far away.
        private function cornersOf(agent:Agent, at:Agent):Vector.<Number>
        {
            var hierarchy:ModelTree = _greatLand.hierarchies.treeOf(agent.shape);
            var placement:Placement = agent.freshPlacement();
            var corners:Vector.<Number> = new Vector.<Number>();
            for each (var vertex:int in hierarchy.boxTree.triangles)
            {
                var x:Number = hierarchy.boxTree.vertices[3 * vertex] * placement.size;
                var y:Number = hierarchy.boxTree.vertices[3 * vertex + 1] * placement.size;
                var z:Number = hierarchy.boxTree.vertices[3 * vertex + 2] * placement.size;
                corners.push(placement.r00 * x + placement.r01 * y + placement.r02 * z + (agent.x - at.x),
                        placement.r10 * x + placement.r11 * y + placement.r12 * z + (agent.y - at.y),
                        placement.r20 * x + placement.r21 * y + placement.r22 * z + (agent.z - at.z));
            }
            return corners;
        }

        private function least(a:Vector.<BoundingStructure>, b:Vector.<BoundingStructure>):Number
        {
            var distance:Number = Infinity;
            for (var i:int = 0; i < a.length; i++)
            {
                for (var k:int = 0; k < b.length; k++)
                {
                    StructurePairs.findClosest(a[i], b[k], _pair);
                    distance = Math.min(distance, _pair.distance);
                }
            }
            return distance;
        }
    }
}
