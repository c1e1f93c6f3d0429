package support
{
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.models.Model;

    use namespace engine;

    /** What an agent is in a collision system, as triangles in the world with a radius around them. Spheres and capsules have triangles without area. */
    public final class AgentPieces
    {
        // A rectangle as two triangles.
        private static const CORNERS:Vector.<int> = new <int>[0, 1, 2, 0, 2, 3];

        // How many levels of a tree a system visits, unless it is told otherwise.
        private static const LEVELS:int = 5;

        /**
         * The pieces of an agent: objects with a <code>radius</code>, and <code>points</code>, nine numbers for each triangle.
         *
         * @param system one of EachCollider.ALL_NAMES
         * @param land has the model
         */
        public static function of(system:String, agent:Agent, land:GreatLand, model:Model):Array
        {
            if (system == "bins")
            {
                return [ofStructure(new Sphere(new Vector3D(agent.x, agent.y, agent.z + agent.size / 2), agent.size / 2))];
            }
            if (system == "tightest fits" || !agent.hierarchical && system.indexOf("combinations") == 0)
            {
                return [ofStructure(TransformedStructure.of(land.boundingStructures.tightestFit(agent.shape), agent))];
            }
            var pieces:Array = [];
            if (system == "hierarchies" || system == "combinations")
            {
                addEnds(land.hierarchies.root(agent.shape), LEVELS, agent, pieces);
                return pieces;
            }
            var corners:Vector.<Number> = new Vector.<Number>();
            EveryTriangle.place(agent.freshPlacement(), model, corners);
            for (var i:int = 0; i < corners.length; i += 9)
            {
                pieces.push({radius: 0, points: corners.slice(i, i + 9)});
            }
            return pieces;
        }

        private static function addEnds(node:HierarchyNode, levels:int, agent:Agent, pieces:Array):void
        {
            if (levels == 1 || node.isLeaf)
            {
                pieces.push(ofStructure(TransformedStructure.of(node.bounds, agent)));
                return;
            }
            addEnds(node.left, levels - 1, agent, pieces);
            addEnds(node.right, levels - 1, agent, pieces);
        }

        private static function ofStructure(structure:BoundingStructure):Object
        {
            if (structure is Sphere)
            {
                return {radius: Sphere(structure).radius, points: segment(Sphere(structure).center, Sphere(structure).center)};
            }
            if (structure is Capsule)
            {
                return {radius: Capsule(structure).radius, points: segment(Capsule(structure).start, Capsule(structure).end)};
            }
            return {radius: 0, points: sidesOf(Box(structure))};
        }

        private static function segment(start:Vector3D, end:Vector3D):Vector.<Number>
        {
            return new <Number>[start.x, start.y, start.z, end.x, end.y, end.z, end.x, end.y, end.z];
        }

        private static function sidesOf(box:Box):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            var signs:Vector.<Number> = new Vector.<Number>(3);
            // by side: the axis across it, and its four corners round
            for (var i:int = 0; i < 36; i++)
            {
                var side:int = i / 6;
                var corner:int = CORNERS[i % 6];
                signs[side >> 1] = side % 2 == 0 ? -1 : 1;
                signs[((side >> 1) + 1) % 3] = corner == 1 || corner == 2 ? 1 : -1;
                signs[((side >> 1) + 2) % 3] = corner >= 2 ? 1 : -1;
                var x:Number = signs[0] * box.halfX;
                var y:Number = signs[1] * box.halfY;
                var z:Number = signs[2] * box.halfZ;
                points.push(box.center.x + x * box.axisX.x + y * box.axisY.x + z * box.axisZ.x,
                        box.center.y + x * box.axisX.y + y * box.axisY.y + z * box.axisZ.y,
                        box.center.z + x * box.axisX.z + y * box.axisY.z + z * box.axisZ.z);
            }
            return points;
        }
    }
}
