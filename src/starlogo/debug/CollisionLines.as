package starlogo.debug
{
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.BaseCollider;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collider;
    import starlogo.collision.CollisionSystem;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.placePoints;
    import starlogo.models.Model;
    import starlogo.search.BaseShapeChoice;
    import starlogo.search.ModelShape;
    import starlogo.search.TightestFitChoice;
    import starlogo.search.TreeLimits;

    use namespace engine;

    /**
     * Lines to draw that show what a collision system tests for an agent, in world coordinates (§7.3). They show the agent's unit sphere,
     * its structure, the level of its hierarchy at which the collider stops, or in exact mode its triangles.
     *
     * <p>Lines are appended to <code>out</code>, so that one list takes those of many agents. Set its length to 0 before each frame. Other calls of
     * the engine overwrite theirs.</p>
     */
    public final class CollisionLines
    {
        // The shapes of a system that is not the engine's, which tells nothing about them.
        private var _tightest:TightestFitChoice;

        // The wireframes in the models' space, by the depth that is drawn, kind and model. They are valid for one choice of shapes and one revision of
        // its models.
        private var _wireframes:Object = {};
        private var _choice:BaseShapeChoice = null;
        private var _revision:int = -1;

        /**
         * Creates lines for agents.
         *
         * @param greatLand has the models of a collision system that is not the engine's
         * @throws ArgumentError if it is null
         */
        public function CollisionLines(greatLand:GreatLand)
        {
            requireGiven("greatLand", greatLand);
            _tightest = new TightestFitChoice(greatLand);
        }

        /**
         * The lines of the shape that a collision system tests for an agent. While the agent's model is loading, if it was removed from the GreatLand,
         * and for the ground and the edges of the world there are none. The lines of a model are computed on the first call, and after a call with
         * another system. Other calls take a time proportional to the number of lines.
         *
         * @param agent any agent
         * @param system has the shapes: one of the engine's systems, a LevelCollider, or a Collider with a ShapeChoice of the game's own. For a system
         *     that is none of these, the lines are those of the tightest fits
         * @param out the lines are appended to it, six numbers each as in Wireframes; created if null
         * @return out
         * @throws ArgumentError if the agent is null, if the collision system needs data of the agent's model that was not loaded, or if the models of
         *     a LevelCollider are not the agent's
         */
        public function linesOf(agent:Agent, system:CollisionSystem, out:Vector.<Number> = null):Vector.<Number>
        {
            requireGiven("agent", agent);
            var collider:Collider = BaseCollider.wrap(system).samePairsCollider;
            var choice:BaseShapeChoice = collider == null ? _tightest : collider.narrowPhase.shapeChoice;
            var all:Vector.<Number> = out || new Vector.<Number>();
            // a BinCollider may be without models, and its agents have any shapes
            if (agent.isEnvironment || choice.greatLand != null && !choice.greatLand.hasModel(agent.shape))
            {
                return all;
            }
            if (collider is BinCollider)
            {
                var radius:Number = agent.size / 2;
                return Wireframes.ofStructure(new Sphere(new Vector3D(agent.x, agent.y, agent.z + radius), radius), all);
            }
            // A Matrix3D is not used, because it has single precision.
            var wireframe:Vector.<Number> = wireframeOf(agent, choice, collider);
            return placePoints(agent.freshPlacement(), wireframe, 0, wireframe.length, all, all.length);
        }

        private function wireframeOf(agent:Agent, choice:BaseShapeChoice, collider:Collider):Vector.<Number>
        {
            if (_choice !== choice || _revision != choice.revision)
            {
                _choice = choice;
                _revision = choice.revision;
                _wireframes = {};
                choice.forgetReplaced();
            }
            var shape:ModelShape = choice.shapeOf(agent);
            var depth:int = shape.tree == null ? 0 : depthOf(shape.model, agent, collider.narrowPhase.treeLimits);
            var key:String = depth + " " + shape.variant + " " + shape.modelName;
            return _wireframes[key] ||= draw(shape, depth);
        }

        // Draws a structure, or a tree down to a depth, or with depth 0 the triangles that belong to the tree.
        private static function draw(shape:ModelShape, depth:int):Vector.<Number>
        {
            if (shape.tree == null)
            {
                return Wireframes.ofStructure(shape.structure);
            }
            return depth == 0 ? Wireframes.ofTriangles(shape.model.vertices, shape.model.triangles) : Wireframes.ofLevel(shape.tree.root, depth);
        }

        // The depth to which an agent's tree is tested; 0 if triangles decide. In exact mode these decide, or the leaves of a model without triangles.
        private static function depthOf(model:Model, agent:Agent, limits:TreeLimits):int
        {
            if (limits.isExact)
            {
                return model.triangles == null ? int.MAX_VALUE : 0;
            }
            return agent.traversalDepth > 0 ? agent.traversalDepth : limits.maxDepth;
        }
    }
}
