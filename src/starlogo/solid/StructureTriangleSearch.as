package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.TriangleKernel;

    use namespace engine;

    /**
     * Finds the triangle of a model that a solid structure first touches, or that is nearest to it. Extents rule out most triangles, SweptAxes those
     * beside a motion; the triangles' planes come last.
     */
    internal final class StructureTriangleSearch
    {
        // Finds the leaves near the structure's extents.
        private var _search:BoxSearch;
        private var _kernel:TriangleKernel;
        private var _counts:TreeCounts;

        // The extents of the moving structure's core at time 0: minX, maxX, minY, ... The core of a round structure is a point or a segment.
        private var _coreExtents:Vector.<Number> = new Vector.<Number>(6, true);

        // The extents near which a triangle is tested: of the core on its motion until the latest time, or of the structure whose nearest triangle is sought.
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // Separates most triangles from the moving structure.
        private var _separatingAxes:SweptAxes = new SweptAxes();

        // The corners of a triangle, and its plane with the distance of quick tests.
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);
        private var _plane:TrianglePlane = new TrianglePlane();

        // The triangle that is touched first.
        private var _first:FirstImpact = new FirstImpact();

        /**
         * @param kernel has the structure as its shape
         * @param counts counts the nodes that are visited and the triangles that are tested
         */
        public function StructureTriangleSearch(kernel:TriangleKernel, counts:TreeCounts)
        {
            _kernel = kernel;
            _counts = counts;
            _search = new BoxSearch(counts);
        }

        /**
         * Finds when a structure first touches a triangle of a model, and which one.
         *
         * @param tree the model's, with its triangles' corners listed
         * @param structure in the model's space. The margin of the kernel's shape includes the rounding error of its place
         * @param motion of the structure, from that place on; receives the time, and its earliest and latest times are overwritten. If it is still, the
         *     structure touches at time 0 or never
         * @return the triangle's index, or -1
         */
        public function findFirst(tree:BoxTree, structure:BoundingStructure, motion:RelativeMotion):int
        {
            beginSweep(tree, structure, motion);
            var leaf:int = _search.nextMet();
            while (leaf >= 0)
            {
                testTriangles(tree, leaf, motion);
                // nothing is touched earlier than at the beginning
                leaf = _first.time > 0 ? _search.nextMet() : -1;
            }
            motion.time = _first.time;
            return _first.a;
        }

        private function beginSweep(tree:BoxTree, structure:BoundingStructure, motion:RelativeMotion):void
        {
            var extents:Vector.<Number> = _coreExtents;
            var shape:ConvexShape = _kernel.shape;
            _first.reset();
            structure.extentsInto(extents);
            shape.margin += Touching.marginOfSurface(tree.boundingRadius);
            var size:Number = 3 * shape.margin + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z);
            for (var i:int = 0; i < 6; i += 2)
            {
                size += Math.max(Math.abs(extents[i]), Math.abs(extents[int(i + 1)]));
            }
            var distance:Number = shape.radius + shape.margin + Tolerances.EXTENTS * size;
            var widening:Number = distance - shape.radius;
            for (i = 0; i < 6; i += 2)
            {
                _extents[i] = extents[i] - widening;
                _extents[int(i + 1)] = extents[int(i + 1)] + widening;
                extents[i] += shape.radius;
                extents[int(i + 1)] -= shape.radius;
            }
            _search.setExtents(_extents);
            _plane.cullDistance = _separatingAxes.cullDistance = distance;
            _separatingAxes.setTo(shape, motion);
            sweepExtents(motion);
            _search.beginMet(tree, BoxTree.EXACT, motion);
        }

        // Writes the extents of the core on its motion until the latest time.
        private function sweepExtents(motion:RelativeMotion):void
        {
            var x:Number = motion.latestTime * motion.x;
            var y:Number = motion.latestTime * motion.y;
            var z:Number = motion.latestTime * motion.z;
            _extents[0] = _coreExtents[0] + Math.min(x, 0);
            _extents[1] = _coreExtents[1] + Math.max(x, 0);
            _extents[2] = _coreExtents[2] + Math.min(y, 0);
            _extents[3] = _coreExtents[3] + Math.max(y, 0);
            _extents[4] = _coreExtents[4] + Math.min(z, 0);
            _extents[5] = _coreExtents[5] + Math.max(z, 0);
        }

        // Offers the triangles of a leaf that are touched. The motion ends at the first touch so far, and a little later.
        private function testTriangles(tree:BoxTree, leaf:int, motion:RelativeMotion):void
        {
            var isStill:Boolean = motion.isStill;
            var end:int = tree.endPrimitive[leaf];
            for (var i:int = tree.firstPrimitive[leaf]; i < end; i++)
            {
                if (!areExtentsWithin(_plane.cullDistance, _extents, tree, i))
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
                if (_first.offer(motion, _plane))
                {
                    _first.a = i;
                }
                if (!(_first.time > 0))
                {
                    return;
                }
                if (motion.latestTime < _search.limit)
                {
                    _search.limit = motion.latestTime;
                    sweepExtents(motion);
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

        /**
         * Finds the distance and the closest points of a model and a structure.
         *
         * @param tree the model's, with its triangles' corners listed
         * @param structure in the model's space
         * @param out receives them, in the model's space, the model's point first
         * @return the index of the nearest triangle; -1 if rounding leaves none
         */
        public function findNearest(tree:BoxTree, structure:BoundingStructure, out:ClosestPoints):int
        {
            var nearest:int = -1;
            structure.extentsInto(_extents);
            out.distance = Infinity;
            _search.setExtents(_extents);
            _search.beginNear(tree, BoxTree.EXACT);
            for (var leaf:int = _search.nextNear(); leaf >= 0; leaf = _search.nextNear())
            {
                var end:int = tree.endPrimitive[leaf];
                for (var i:int = tree.firstPrimitive[leaf]; i < end && out.distance > 0; i++)
                {
                    if (areExtentsWithin(out.distance, _extents, tree, i))
                    {
                        _counts.triangleTests++;
                        tree.readTriangle(i, _corners);
                        nearest = _kernel.findCloser(_corners, out) ? i : nearest;
                    }
                }
                _search.limit = out.distance;
            }
            if (nearest >= 0)
            {
                // the kernel has the structure's point first
                out.swap();
            }
            return nearest;
        }
    }
}
