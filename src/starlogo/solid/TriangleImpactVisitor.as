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
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.TriangleKernel;

    use namespace engine;

    /**
     * Decides when a solid structure first touches a triangle of a model, and whether it does if it is still. Their extents rule out most triangles;
     * SweptAxes those beside a motion; their planes come last.
     */
    internal final class TriangleImpactVisitor extends NodeVisitor
    {
        // Finds the nodes near the structure's extents.
        private var _search:BoxSearch;
        private var _counts:TreeCounts;

        // The structure's motion, which has the times of the current triangle.
        private var _motion:RelativeMotion;
        private var _kernel:TriangleKernel;

        // The extents of the structure's core where it is at time 0, and on its motion until the limit: minX, maxX, minY, ... The core of a round
        // structure is a point or a segment.
        private var _coreExtents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _sweptExtents:Vector.<Number> = new Vector.<Number>(6, true);

        // Separates most triangles from the moving structure.
        private var _separatingAxes:SweptAxes = new SweptAxes();

        // The corners of a triangle, and its plane with the distance of quick tests.
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);
        private var _plane:TrianglePlane = new TrianglePlane();

        // The index of the triangle that is touched first, and what chooses it.
        private var _found:int = -1;
        private var _firstImpact:FirstImpact = new FirstImpact();

        /**
         * @param kernel has the structure as its shape
         * @param counts counts the nodes that are visited and the triangles that are tested
         */
        public function TriangleImpactVisitor(kernel:TriangleKernel, counts:TreeCounts)
        {
            _kernel = kernel;
            _counts = counts;
            _search = new BoxSearch(counts);
        }

        /**
         * Finds when a structure first touches a triangle of a model, and which one.
         *
         * @param tree the model's, with its triangles' corners listed
         * @param structure in the model's space
         * @param pose has the margin of the structure's place
         * @param motion of the structure, from the pose on; receives the time, and its earliest and latest times are overwritten. If it is still, the
         *     structure touches at time 0 or never
         * @return the triangle's index, or -1
         */
        public function findFirstTriangle(tree:BoxTree, structure:BoundingStructure, pose:RelativePose, motion:RelativeMotion):int
        {
            var extents:Vector.<Number> = _coreExtents;
            var shape:ConvexShape = _kernel.shape;
            limit = motion.latestTime;
            _motion = motion;
            _firstImpact.reset();
            _found = -1;
            structure.extentsInto(extents);
            shape.margin += pose.margin + Touching.marginOfSurface(tree.boundingRadius);
            var size:Number = 3 * shape.margin + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z);
            for (var i:int = 0; i < 6; i += 2)
            {
                size += Math.max(Math.abs(extents[i]), Math.abs(extents[int(i + 1)]));
                extents[i] += shape.radius;
                extents[int(i + 1)] -= shape.radius;
            }
            _plane.cullDistance = shape.radius + shape.margin + Tolerances.EXTENTS * size;
            _search.setExtents(extents, _plane.cullDistance);
            _search.setMotion(motion);
            _separatingAxes.setTo(shape, _plane.cullDistance, motion);
            sweepExtents();
            _search.visitMet(tree, BoxTree.EXACT, this);
            motion.time = _firstImpact.time;
            return _found;
        }

        private function sweepExtents():void
        {
            sweepAlong(0, limit * _motion.x);
            sweepAlong(2, limit * _motion.y);
            sweepAlong(4, limit * _motion.z);
        }

        // Writes the extents along an axis, which begin at an index, of the core and of its travel along that axis.
        private function sweepAlong(at:int, travel:Number):void
        {
            var back:Number = travel < 0 ? travel : 0;
            var ahead:Number = travel > 0 ? travel : 0;
            _sweptExtents[at] = _coreExtents[at] + back;
            _sweptExtents[int(at + 1)] = _coreExtents[int(at + 1)] + ahead;
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            var motion:RelativeMotion = _motion;
            var isStill:Boolean = motion.isStill;
            var end:int = tree.endPrimitive[node];
            for (var i:int = tree.firstPrimitive[node]; i < end && limit >= 0; i++)
            {
                if (!areExtentsWithin(_plane.cullDistance, _sweptExtents, tree, i))
                {
                    continue;
                }
                tree.readTriangle(i, _corners);
                if (!isStill && _separatingAxes.areApart(_corners))
                {
                    continue;
                }
                _plane.setTriangle(_corners, 0);
                motion.earliestTime = _plane.timeOfEntry(_kernel.shape, motion);
                if (motion.earliestTime > motion.latestTime)
                {
                    continue;
                }
                _counts.triangleTests++;
                if (isStill)
                {
                    motion.time = _kernel.areTouching(_corners) ? 0 : RelativeMotion.NEVER;
                }
                else
                {
                    _kernel.findTimeOfImpact(_corners, motion);
                }
                if (_firstImpact.offer(motion, _plane))
                {
                    _found = i;
                }
                if (!(_firstImpact.time > 0))
                {
                    endSearch();
                }
                else if (motion.latestTime < limit)
                {
                    limit = motion.latestTime;
                    sweepExtents();
                }
            }
        }

        /**
         * Finds the contact of a triangle that is touched, in the model's space. The structure is that of the last search.
         *
         * @param tree the model's
         * @param index the triangle's primitive index
         * @param motion of the structure, which is where it is at the motion's time
         * @param out receives the contact, with a normal from the triangle to the structure
         */
        public function findContact(tree:BoxTree, index:int, motion:RelativeMotion, out:ContactPoint):void
        {
            tree.readTriangle(index, _corners);
            _kernel.findContact(_corners, motion, out);
            _plane.setTriangle(_corners, 0);
            _plane.alignContact(_kernel.shape, motion, out);
        }
    }
}
