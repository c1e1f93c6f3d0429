package starlogo.blocks
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.collision.PreciseCollider;
    import starlogo.debug.Wireframes;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /** The block "show bounding structures": which agents it shows, and the lines of what the collision system in use tests. */
    public class StructureBlocks
    {
        private var _collisions:CollisionBlocks;
        private var _shown:Array = [];

        // The lines of the structures, in the models' spaces, by level, kind and model; for one revision of the models.
        private var _lines:Object = {};
        private var _revision:int = -1;

        /**
         * Shows no agent's structures.
         *
         * @param collisions know the agents, and the collision system in use
         * @throws ArgumentError if it is null
         */
        public function StructureBlocks(collisions:CollisionBlocks)
        {
            if (collisions == null)
            {
                throw new ArgumentError("collision blocks are needed, not null");
            }
            _collisions = collisions;
        }

        /**
         * The block "show bounding structures".
         *
         * @param subject an agent, or the name of a breed
         * @param isOn whether to show them, or to cease to
         * @throws BlockError if it is neither
         */
        public function show(subject:Object, isOn:Boolean):void
        {
            BlockSubject.check("show bounding structures", subject);
            var place:int = _shown.indexOf(subject);
            if (isOn && place < 0)
            {
                _shown.push(subject);
            }
            else if (!isOn && place >= 0)
            {
                _shown.splice(place, 1);
            }
        }

        /** Shows no agent's structures any more. */
        public function showNone():void
        {
            _shown.length = 0;
        }

        /** Whether an agent's structures are shown, for itself or for its breed. */
        public function isShown(agent:Agent):Boolean
        {
            for each (var subject:Object in _shown)
            {
                if (BlockSubject.includes(subject, agent))
                {
                    return true;
                }
            }
            return false;
        }

        /**
         * The lines of all that is shown, in the world: six numbers each, x, y and z of one end, then of the other.
         *
         * @param out the lines are added to it; made if null
         * @return out
         */
        public function lines(out:Vector.<Number> = null):Vector.<Number>
        {
            var all:Vector.<Number> = out || new Vector.<Number>();
            for each (var agent:Agent in _collisions.agents)
            {
                if (isShown(agent))
                {
                    linesOf(agent, all);
                }
            }
            return all;
        }

        /**
         * The lines of what the collision system in use tests of an agent, shown or not; none while its model is loading. Of a hierarchy,
         * the level at which the collider stops; in exact mode the leaves, whose triangles decide.
         *
         * @param agent one of the game
         * @param out the lines are added to it; made if null
         * @return out, in the world as in <code>lines()</code>
         * @throws ArgumentError if what the collision system needs of the agent's model was not loaded
         */
        public function linesOf(agent:Agent, out:Vector.<Number> = null):Vector.<Number>
        {
            if (_collisions.systemName == CollisionBlocks.UNIT_SPHERES)
            {
                var radius:Number = agent.size / 2;
                return Wireframes.ofStructure(new Sphere(new Vector3D(agent.x, agent.y, agent.z + radius), radius), out);
            }
            var all:Vector.<Number> = out || new Vector.<Number>();
            return _collisions.greatLand.hasModel(agent.shape) ? placed(linesOfModel(agent), agent.worldPlacement(), all) : all;
        }

        private function linesOfModel(agent:Agent):Vector.<Number>
        {
            if (_revision != _collisions.greatLand.revision)
            {
                _revision = _collisions.greatLand.revision;
                _lines = {};
            }
            var level:int = isHierarchy(agent) ? levelOf(agent) : 0;
            var key:String = level + " " + agent.structureKind + " " + agent.shape;
            if (_lines[key] == null)
            {
                _lines[key] = level > 0 ? Wireframes.ofLevel(_collisions.greatLand.hierarchies.root(agent.shape), level)
                    : Wireframes.ofStructure(structureOf(agent));
            }
            return _lines[key];
        }

        private function isHierarchy(agent:Agent):Boolean
        {
            var isCombination:Boolean = _collisions.systemName == CollisionBlocks.COMBINATION;
            return isCombination ? agent.hierarchical : _collisions.systemName != CollisionBlocks.TIGHTEST_FITS;
        }

        private function levelOf(agent:Agent):int
        {
            var collider:PreciseCollider = PreciseCollider(_collisions.collision.collisionSystem);
            if (collider.exact)
            {
                return int.MAX_VALUE;
            }
            return agent.traversalDepth > 0 ? agent.traversalDepth : collider.maxDepth;
        }

        private function structureOf(agent:Agent):BoundingStructure
        {
            if (agent.structureKind == Agent.ANY_KIND)
            {
                return _collisions.greatLand.boundingStructures.tightestFit(agent.shape);
            }
            return _collisions.greatLand.structureOfKind(agent.shape, agent.structureKind);
        }

        // Not by a Matrix3D, which has single precision.
        private static function placed(lines:Vector.<Number>, placement:Placement, out:Vector.<Number>):Vector.<Number>
        {
            var size:Number = placement.size;
            for (var i:int = 0; i < lines.length; i += 3)
            {
                var x:Number = lines[i];
                var y:Number = lines[i + 1];
                var z:Number = lines[i + 2];
                out.push(placement.x + size * (placement.r00 * x + placement.r01 * y + placement.r02 * z),
                        placement.y + size * (placement.r10 * x + placement.r11 * y + placement.r12 * z),
                        placement.z + size * (placement.r20 * x + placement.r21 * y + placement.r22 * z));
            }
            return out;
        }
    }
}
