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
    import starlogo.geometry.Placement;
    import starlogo.models.Model;
    import starlogo.search.BaseShapeChoice;
    import starlogo.search.ModelShape;
    import starlogo.search.TightestFitChoice;
    import starlogo.search.TreeLimits;

    use namespace engine;

    /**
     * Lines to draw that show what a collision system tests for an agent, in world coordinates (§7.3). They show the agent's unit sphere,
     * its structure, the level of its hierarchy at which the collider stops, or in exact mode its triangles.
     */
    public final class CollisionLines
    {
        private var _greatLand:GreatLand;

        // The lines in model space, by level, kind and model. They are valid for one collider and one revision of the models.
        private var _lines:Object = {};
        private var _collider:Collider = null;
        private var _revision:int = -1;

        /**
         * Creates lines for agents whose models a GreatLand has.
         *
         * @throws ArgumentError if it is null
         */
        public function CollisionLines(greatLand:GreatLand)
        {
            requireGiven("greatLand", greatLand);
            _greatLand = greatLand;
        }

        /**
         * The lines of the shape that a collision system tests for an agent. While the agent's model is loading, and if it was removed, there are
         * none. The lines of a model are computed on the first call, and after a call with another system. Other calls take a time proportional
         * to the number of lines.
         *
         * @param agent any agent
         * @param system one of the engine's systems, or a Collider with a ShapeChoice of the game's own, with the same GreatLand
         * @param out the lines are appended to it, six numbers each as in Wireframes; created if null
         * @return out
         * @throws ArgumentError if the agent is null, or if the collision system needs data of the agent's model that was not loaded
         */
        public function linesOf(agent:Agent, system:CollisionSystem, out:Vector.<Number> = null):Vector.<Number>
        {
            requireGiven("agent", agent);
            var collider:Collider = BaseCollider.wrap(system).equivalentCollider;
            var all:Vector.<Number> = out || new Vector.<Number>();
            // a BinCollider may be without models, and its agents have any shapes
            var models:GreatLand = collider == null ? _greatLand : collider.narrowPhase.choice.greatLand;
            if (models != null && !models.hasModel(agent.shape))
            {
                return all;
            }
            if (collider is BinCollider)
            {
                var radius:Number = agent.size / 2;
                return Wireframes.ofStructure(new Sphere(new Vector3D(agent.x, agent.y, agent.z + radius), radius), all);
            }
            // A Matrix3D is not used, because it has single precision.
            var lines:Vector.<Number> = linesOfModel(agent, collider);
            return Placement.placePoints(agent.worldPlacement(), lines, 0, lines.length, all, all.length);
        }

        private function linesOfModel(agent:Agent, collider:Collider):Vector.<Number>
        {
            if (_collider !== collider || _revision != _greatLand.revision)
            {
                _collider = collider;
                _revision = _greatLand.revision;
                _lines = {};
            }
            // a system that is not the engine's tells nothing about its shapes
            var choice:BaseShapeChoice = collider == null ? new TightestFitChoice(_greatLand) : collider.narrowPhase.choice;
            var level:int = collider == null || collider.narrowPhase.treeTests == null ? 0 : levelOf(agent, collider.narrowPhase.treeLimits);
            var key:String = level + " " + choice.kindOf(agent) + " " + agent.shape;
            if (_lines[key] == null)
            {
                var shape:ModelShape = new ModelShape(agent.shape, choice.kindOf(agent), _revision);
                choice.bind(shape, agent);
                _lines[key] = shape.hierarchy == null ? Wireframes.ofStructure(shape.structure) : linesOfTree(shape, level);
            }
            return _lines[key];
        }

        private function linesOfTree(shape:ModelShape, level:int):Vector.<Number>
        {
            var model:Model = _greatLand.modelOf(shape.modelName);
            return level == int.MAX_VALUE && model.triangles != null ? Wireframes.ofTriangles(model.vertices, model.triangles)
                : Wireframes.ofLevel(shape.hierarchy.root, level);
        }

        // In exact mode all levels, because the triangles decide.
        private static function levelOf(agent:Agent, limits:TreeLimits):int
        {
            if (limits.exact)
            {
                return int.MAX_VALUE;
            }
            return agent.traversalDepth > 0 ? agent.traversalDepth : limits.maxDepth;
        }
    }
}
