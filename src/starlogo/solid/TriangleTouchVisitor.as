package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TouchVisitor;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.intersection.TriangleKernel;

    use namespace engine;

    /**
     * Decides when a solid structure first touches a triangle of a model, and whether it does if it is still. Most triangles are ruled out by their
     * extents. If the structure moves, SweptAxes rules out most of the others. Their planes come last.
     */
    internal final class TriangleTouchVisitor extends TouchVisitor
    {
        private var _mesh:TriangleMesh;
        private var _kernel:TriangleKernel = new TriangleKernel();

        // The radius around the structure's core, with the tolerance and a margin for rounding.
        private var _radius:Number = 0;

        // Separates most triangles from the moving structure.
        private var _separatingAxes:SweptAxes = new SweptAxes();

        // The plane of a triangle.
        private var _plane:TrianglePlane = new TrianglePlane();

        /** @param counts counts the nodes that are visited and the triangles that are tested */
        public function TriangleTouchVisitor(counts:TreeCounts)
        {
            super(counts);
        }

        /**
         * Finds when a structure first touches a triangle of a model, and which one.
         *
         * @param model the model; has triangles
         * @param structure in the space of another model
         * @param pose the other model's pose in the first one's space
         * @param motion of the structure, from the pose on; receives the time. If it is still, the structure touches at time 0 or never
         * @return the triangle's slot, or -1
         */
        public function findTouch(model:ModelTree, structure:BoundingStructure, pose:RelativePose, motion:RelativeMotion):int
        {
            setMotion(motion);
            _mesh = model.mesh;
            setStructure(model, structure, pose);
            return findFirst(model.boxTree, BoxTree.EXACT);
        }

        private function setStructure(model:ModelTree, structure:BoundingStructure, pose:RelativePose):void
        {
            _kernel.setStructure(structure, pose.placement).extentsInto(extents);
            _kernel.shape.margin += pose.tolerance + Touching.marginOfSurface(model.boxTree.radius);
            var shape:ConvexShape = _kernel.shape;
            var size:Number = 3 * shape.margin + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z);
            for (var i:int = 0; i < 6; i += 2)
            {
                size += Math.max(Math.abs(extents[i]), Math.abs(extents[int(i + 1)]));
            }
            var rounding:Number = Tolerances.EXTENTS * size;
            _radius = shape.radius + shape.margin + rounding;
            search.setExtents(extents, shape.margin + rounding);
            sweepExtents();
            if (!motion.isStill)
            {
                _separatingAxes.setTo(shape, _radius, motion);
            }
        }

        // Sets the extents to those of the structure's core while it moves, from the motion's earliest time to the limit. The core of a round structure is a
        // point or a segment.
        private function sweepExtents():void
        {
            sweepAlong(0, search.x, search.halfX - _radius, motion.x);
            sweepAlong(2, search.y, search.halfY - _radius, motion.y);
            sweepAlong(4, search.z, search.halfZ - _radius, motion.z);
        }

        // Does it along an axis. The middle and the half-extent are those of the core at time 0. The travel is the whole motion's.
        private function sweepAlong(axis:int, middle:Number, half:Number, travel:Number):void
        {
            var begin:Number = travel * motion.earliest;
            var end:Number = travel * limit;
            var low:Number = begin < end ? begin : end;
            var high:Number = begin < end ? end : begin;
            extents[axis] = middle - half + low;
            extents[int(axis + 1)] = middle + half + high;
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            var isStill:Boolean = motion.isStill;
            var end:int = tree.end[node];
            for (var i:int = tree.first[node]; i < end && limit >= 0; i++)
            {
                if (squaredDistanceToExtents(extents, _mesh.corners, 9 * i) > _radius * _radius)
                {
                    continue;
                }
                if (!isStill && _separatingAxes.stayApart(_mesh.corners, 9 * i, sweep))
                {
                    continue;
                }
                _plane.setTriangle(_mesh.corners, 9 * i);
                sweep.earliest = Math.max(motion.earliest, _plane.findEntry(_kernel.shape, _radius, motion));
                if (sweep.earliest > limit)
                {
                    continue;
                }
                search.counts.triangleTests++;
                if (isStill)
                {
                    sweep.time = _kernel.areTouching(_mesh.corners, 9 * i) ? 0 : RelativeMotion.NEVER;
                }
                else
                {
                    _kernel.findTime(_mesh.corners, 9 * i, sweep);
                }
                if (keepEarlier(i))
                {
                    sweepExtents();
                }
            }
        }

        /**
         * Finds the contact of a triangle that is touched, in the model's space. The model and the structure are those of the last search.
         *
         * @param slot the triangle's slot
         * @param motion of the structure, which is where it is at the motion's time
         * @param out receives the contact, with a normal from the triangle to the structure
         */
        public function findContact(slot:int, motion:RelativeMotion, out:ContactPoint):void
        {
            _kernel.findContact(_mesh.corners, 9 * slot, motion, out);
        }
    }
}
