package starlogo.away3d
{
    import away3d.bounds.AxisAlignedBoundingBox;
    import away3d.bounds.BoundingVolumeBase;
    import away3d.entities.SegmentSet;
    import away3d.primitives.LineSegment;
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.debug.Wireframes;
    import starlogo.hierarchy.HierarchyNode;

    /**
     * Draws an agent's bounding structure, or a level of its hierarchy, as lines in an Away3D scene. The lines move with the agent. The
     * parent must be the land, as for an Away3dAgentBinding's object.
     *
     * <listing version="3.0">
     * var wireframe:Away3dWireframe = new Away3dWireframe(bear);
     * wireframe.showStructure(greatLand.boundingStructures.tightestFit(bear.shape));
     * scene.addChild(wireframe);
     * wireframe.update();     // every frame
     * </listing>
     */
    public final class Away3dWireframe extends SegmentSet
    {
        private var _binding:Away3dAgentBinding;
        private var _color:uint;
        private var _thickness:Number;

        /**
         * Creates a wireframe without lines.
         *
         * @param agent the agent
         * @param color the lines' colour: 0xrrggbb
         * @param thickness the lines' thickness, as for LineSegment
         * @throws ArgumentError if the agent is null
         */
        public function Away3dWireframe(agent:Agent, color:uint = 0xffcc00, thickness:Number = 1)
        {
            _binding = new Away3dAgentBinding(agent, this);
            _color = color;
            _thickness = thickness;
        }

        /**
         * Shows a structure and removes the lines shown before.
         *
         * @param structure in the model's space, as a library has it
         * @throws ArgumentError if it is null
         */
        public function showStructure(structure:BoundingStructure):void
        {
            show(Wireframes.ofStructure(structure));
        }

        /**
         * Shows the structures that a collider reaches if it visits this many levels of a hierarchy. Removes the lines shown before.
         *
         * @param root the hierarchy's root
         * @param level from 1
         * @throws ArgumentError if the root is null
         * @throws RangeError if the level is less than 1
         */
        public function showLevel(root:HierarchyNode, level:int):void
        {
            show(Wireframes.ofLevel(root, level));
        }

        /** Moves the lines to the agent. If the agent has not changed, it does nothing. It allocates nothing. */
        public function update():void
        {
            _binding.updateObject();
        }

        /** @private A box. A SegmentSet's own bounding sphere leaves out the corners. If only these are in view, no lines would be drawn. */
        override protected function getDefaultBoundingVolume():BoundingVolumeBase
        {
            return new AxisAlignedBoundingBox();
        }

        // Creates all segments again, because a segment that is added after a frame is not drawn.
        private function show(lines:Vector.<Number>):void
        {
            removeAllSegments();
            for (var i:int = 0; i < lines.length; i += 6)
            {
                addSegment(new LineSegment(new Vector3D(lines[i], lines[i + 2], lines[i + 1]),
                            new Vector3D(lines[i + 3], lines[i + 5], lines[i + 4]), _color, _color, _thickness));
            }
            update();
        }
    }
}
