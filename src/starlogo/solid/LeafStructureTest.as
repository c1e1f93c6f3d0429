package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.ConvexTriangle;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.DistanceResult;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Decides whether a triangle of a model's leaf touches a solid sphere, capsule or box, when it does so, or how far the two are apart. The ground
     * tests its triangles by the same ConvexTriangle.
     */
    internal final class LeafStructureTest extends LeafTest
    {
        /** The number of triangles tested. The caller sets it to 0. */
        public var triangleTests:int = 0;

        private var _solid:Solid;
        private var _isMeasuring:Boolean = false;
        private var _motion:RelativeMotion;
        private var _test:ConvexTriangle = new ConvexTriangle();

        // The extents of the structure and of its motion: least x, greatest x, least y, ...
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // The index of the first number of the triangle that is touched first.
        private var _first:int = 0;
        private var _corner:Vector3D = new Vector3D();

        public function LeafStructureTest()
        {
            points = new DistanceResult();
        }

        /**
         * Begins with a model that has triangles.
         *
         * @param model the model's hierarchy
         * @param structure in the space of another model
         * @param pose the other model's pose in the first one's space
         * @param motion the structure's motion from there, or RelativeMotion.NONE; kept
         */
        public function begin(model:SolidHierarchy, structure:BoundingStructure, pose:RelativePose, motion:RelativeMotion):void
        {
            _isMeasuring = false;
            _test.margin = pose.gap + Tolerances.SURFACES * model.root.radius;
            place(model, structure, pose, motion);
            _extents[0] += Math.min(motion.x, 0);
            _extents[1] += Math.max(motion.x, 0);
            _extents[2] += Math.min(motion.y, 0);
            _extents[3] += Math.max(motion.y, 0);
            _extents[4] += Math.min(motion.z, 0);
            _extents[5] += Math.max(motion.z, 0);
        }

        /** Begins to measure the distance from a model that has triangles. The parameters are those of <code>begin()</code>. */
        public function beginDistance(model:SolidHierarchy, structure:BoundingStructure, pose:RelativePose):void
        {
            _isMeasuring = true;
            _test.margin = 0;
            place(model, structure, pose, RelativeMotion.NONE);
        }

        /** @inheritDoc */
        override public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            if (_isMeasuring)
            {
                return isNearer(a);
            }
            var latest:Number = _motion === RelativeMotion.NONE ? 0 : least;
            least = RelativeMotion.NEVER;
            for (var i:int = a.first; i < a.end && least > 0; i++)
            {
                if (!isNear(i))
                {
                    continue;
                }
                triangleTests++;
                _test.setTriangle(_solid.corners, 9 * i);
                _test.time = latest;
                _test.findTime();
                if (_test.time < least)
                {
                    least = latest = _test.time;
                    _first = 9 * i;
                }
            }
            return least <= 1;
        }

        /** @inheritDoc */
        override public function findContact(out:ContactPoint):void
        {
            _test.setTriangle(_solid.corners, _first);
            _test.time = _motion.time;
            _test.findContact(out);
            out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
        }

        /** If a corner of the triangle that is touched first is inside of a structure, writes it in place of both closest points. */
        public function takeCorner(structure:BoundingStructure, out:DistanceResult):void
        {
            _corner.setTo(_solid.corners[_first], _solid.corners[int(_first + 1)], _solid.corners[int(_first + 2)]);
            if (structure.contains(_corner))
            {
                out.aX = out.bX = _corner.x;
                out.aY = out.bY = _corner.y;
                out.aZ = out.bZ = _corner.z;
            }
        }

        private function place(model:SolidHierarchy, structure:BoundingStructure, pose:RelativePose, motion:RelativeMotion):void
        {
            _solid = model.facets;
            _motion = motion;
            _test.begin(structure, pose.placement, motion);
            _test.structure.extentsInto(_extents);
        }

        // Whether a triangle in a leaf is nearer than the nearest triangle so far.
        private function isNearer(a:HierarchyNode):Boolean
        {
            var before:Number = least;
            for (var i:int = a.first; i < a.end && least > 0; i++)
            {
                if (squaredGap(i) < least * least)
                {
                    triangleTests++;
                    _test.setTriangle(_solid.corners, 9 * i);
                    _test.measure();
                    least = _test.distance < least ? Math.max(_test.distance, 0) : least;
                }
            }
            if (!(least < before))
            {
                return false;
            }
            _test.writeClosest(points);
            points.swapShapes();
            return true;
        }

        // The squared distance of a triangle's extents from the structure's extents.
        private function squaredGap(triangle:int):Number
        {
            var squared:Number = 0;
            var at:int = 6 * triangle;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var low:Number = _solid.extents[int(at + axis)] - _extents[int(2 * axis + 1)];
                var high:Number = _extents[2 * axis] - _solid.extents[int(at + axis + 3)];
                var gap:Number = Math.max(0, Math.max(low, high));
                squared += gap * gap;
            }
            return squared;
        }

        // Whether the extents of a triangle overlap the structure's extents.
        private function isNear(triangle:int):Boolean
        {
            var of:Vector.<Number> = _solid.extents;
            var at:int = 6 * triangle;
            return of[at] <= _extents[1] && of[int(at + 3)] >= _extents[0] && of[int(at + 1)] <= _extents[3] && of[int(at + 4)] >= _extents[2]
                && of[int(at + 2)] <= _extents[5] && of[int(at + 5)] >= _extents[4];
        }
    }
}
