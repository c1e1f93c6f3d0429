package client
{
    import away3d.core.base.SubMesh;
    import away3d.entities.Mesh;
    import away3d.materials.ColorMaterial;
    import starlogo.agents.Agent;
    import starlogo.away3d.Away3dAgentBinding;
    import starlogo.away3d.Away3dWireframe;
    import starlogo.bounding.BoundingStructure;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.terrain.Terrain;

    /** An agent with its Away3D object. */
    public final class Character
    {
        private static const LINES:uint = 0xffd21f;
        private static const STRUCTURE_THICKNESS:Number = 1.5;
        private static const LEVEL_THICKNESS:Number = 0.9;
        private static const SHADOW_HEIGHT:Number = 0.04;
        private static const COVER:Number = 0.7;

        /** The agent. */
        public var agent:Agent;

        /** How far it moves each frame, in patches: speed along its heading, climb up. */
        public var speed:Number = 0;

        /** @copy #speed */
        public var climb:Number = 0;

        private var _land:Land;
        private var _terrain:Terrain;
        private var _object:Mesh;
        private var _shadow:Mesh;
        private var _binding:Away3dAgentBinding;
        private var _wireframe:Away3dWireframe = null;

        /**
         * @param land shows it
         * @param cast has its shape
         * @param agent the agent
         * @param terrain the ground that its shadow falls on; null for flat ground
         */
        public function Character(land:Land, cast:Cast, agent:Agent, terrain:Terrain = null)
        {
            this.agent = agent;
            _land = land;
            _terrain = terrain;
            _object = cast.draw(agent.shape);
            _binding = new Away3dAgentBinding(agent, _object, cast.model(agent.shape));
            _shadow = land.newShadow();
            _shadow.scaleX = _shadow.scaleZ = agent.size;
            update();
            land.show(_object);
            land.show(_shadow);
        }

        /** Moves it by one frame. */
        public function move():void
        {
            if (speed == 0 && climb == 0)
            {
                return;
            }
            var heading:Number = agent.heading * Math.PI / 180;
            agent.moveTo(agent.x + speed * Math.cos(heading), agent.y + speed * Math.sin(heading), agent.z + climb);
        }

        /** Moves its object to the agent. */
        public function update():void
        {
            _binding.updateObject();
            var ground:Number = _terrain == null ? 0 : _terrain.heightAt(agent.x, agent.y);
            _shadow.moveTo(agent.x, ground + SHADOW_HEIGHT, agent.y);
            if (_wireframe != null)
            {
                _wireframe.update();
            }
        }

        /** Paints it with a translucent colour. */
        public function paint(color:uint):void
        {
            agent.color = color;
            for each (var part:SubMesh in _object.subMeshes)
            {
                part.material = _land.material(mix(ColorMaterial(part.material).color, color));
            }
        }

        /** Shows a structure as a wireframe. */
        public function showStructure(structure:BoundingStructure):void
        {
            newWireframe(STRUCTURE_THICKNESS).showStructure(structure);
        }

        /** Shows a level of a hierarchy as a wireframe. */
        public function showLevel(root:HierarchyNode, level:int):void
        {
            newWireframe(LEVEL_THICKNESS).showLevel(root, level);
        }

        /** Shows no wireframe. */
        public function hideWireframe():void
        {
            if (_wireframe != null)
            {
                _land.hide(_wireframe);
                _wireframe.dispose();
                _wireframe = null;
            }
        }

        /** Removes it from the land. */
        public function leave():void
        {
            hideWireframe();
            _land.hide(_object);
            _land.hide(_shadow);
        }

        private function newWireframe(thickness:Number):Away3dWireframe
        {
            hideWireframe();
            _wireframe = new Away3dWireframe(agent, LINES, thickness);
            _land.show(_wireframe);
            return _wireframe;
        }

        private static function mix(color:uint, paint:uint):uint
        {
            var mixed:uint = 0;
            for (var shift:int = 0; shift < 24; shift += 8)
            {
                var part:Number = (1 - COVER) * (color >> shift & 0xff) + COVER * (paint >> shift & 0xff);
                mixed |= int(part) << shift;
            }
            return mixed;
        }
    }
}
