package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.MovingBoxTraversal;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.ConvexTriangle;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.Zonotope;
    import starlogo.intersection.distance.DistanceResult;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Decides whether a triangle of a model's leaf touches a solid sphere, capsule or box, when it does so, or how far the two are apart. The ground
     * tests its triangles by the same ConvexTriangle. Before that, separating axes rule out most triangles.
     */
    internal final class LeafStructureTest extends LeafTest
    {
        /** The number of triangles tested. The caller sets it to 0. */
        public var triangleTests:int = 0;

        /** Finds the leaves near the structure. */
        public var boxes:MovingBoxTraversal = new MovingBoxTraversal();

        private var _solid:Solid;
        private var _isMeasuring:Boolean = false;
        private var _motion:RelativeMotion;
        private var _test:ConvexTriangle = new ConvexTriangle();

        // The extents of the structure: least x, greatest x, least y, ...
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // The structure's core, and the radius around it, with a margin for rounding.
        private var _core:Zonotope = new Zonotope();
        private var _radius:Number = 0;

        // The normal of a triangle; the motion, or that normal; an axis perpendicular to it. Whether an axis separates the two at the beginning.
        private var _normal:Vector3D = new Vector3D();
        private var _way:Vector3D = new Vector3D();
        private var _along:Vector3D = null;
        private var _across:Vector3D = new Vector3D();
        private var _startsApart:Boolean = false;

        // Whether a triangle is touched, and the index of the first number of the one that is touched first.
        private var _isFound:Boolean = false;
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
            _isMeasuring = _isFound = false;
            _test.margin = pose.gap + Tolerances.SURFACES * model.root.radius;
            place(model, structure, pose, motion);
            _core.setTo(_test.structure, RelativeMotion.NONE);
            var extents:Vector.<Number> = _extents;
            var halfX:Number = (extents[1] - extents[0]) / 2;
            var halfY:Number = (extents[3] - extents[2]) / 2;
            var halfZ:Number = (extents[5] - extents[4]) / 2;
            var margin:Number = Tolerances.EXTENTS * (halfX + halfY + halfZ + Math.abs(_core.x) + Math.abs(_core.y) + Math.abs(_core.z)
                    + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            _radius = _test.radius + margin;
            boxes.setPlace(_core.x, _core.y, _core.z, 0);
            boxes.halfX = halfX + margin;
            boxes.halfY = halfY + margin;
            boxes.halfZ = halfZ + margin;
            boxes.setMotion(motion.x, motion.y, motion.z);
            _way.setTo(motion.x, motion.y, motion.z);
            _along = motion === RelativeMotion.NONE ? _normal : _way;
        }

        /** Searches the model. Returns whether a triangle is touched. If the structure moves, <code>least</code> becomes the time. */
        public function find():Boolean
        {
            least = _motion === RelativeMotion.NONE ? 0 : 1;
            boxes.find(_solid.tree, this);
            least = Math.max(0, least);
            return _isFound;
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
            return isNearer(a);
        }

        /** @inheritDoc */
        override public function look(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                if (isApart(i))
                {
                    continue;
                }
                triangleTests++;
                _test.setTriangle(_solid.corners, 9 * i);
                _test.time = least;
                _test.findTime(_startsApart);
                if (_test.time < least || !_isFound && _test.time == least)
                {
                    _isFound = true;
                    _first = 9 * i;
                    least = _test.time;
                    if (least == 0)
                    {
                        // no triangle can be touched earlier
                        least = -Infinity;
                        return;
                    }
                }
            }
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

        // Whether a separating axis shows that a triangle is apart from the structure until <code>least</code>: an axis of the extents, the normal of
        // the triangle, or an axis across an edge.
        private function isApart(triangle:int):Boolean
        {
            var planes:Vector.<Number> = _solid.planes;
            var at:int = 5 * triangle;
            _normal.x = planes[at];
            _normal.y = planes[int(at + 1)];
            _normal.z = planes[int(at + 2)];
            _core.measure(_normal);
            var reach:Number = _core.reach + _radius + planes[int(at + 4)];
            var from:Number = _normal.x * _core.x + _normal.y * _core.y + _normal.z * _core.z - planes[int(at + 3)];
            var to:Number = from + least * (_normal.x * _motion.x + _normal.y * _motion.y + _normal.z * _motion.z);
            _startsApart = from > reach || from < -reach;
            if (_startsApart && (from > reach ? to > reach : to < -reach))
            {
                return true;
            }
            var corners:Vector.<Number> = _solid.corners;
            at = 9 * triangle;
            return isBeside(corners, at, at + 3, at + 6) || isBeside(corners, at + 3, at + 6, at) || isBeside(corners, at + 6, at, at + 3);
        }

        // Whether the axis perpendicular to the edge from p to q and to the motion separates the two; for a standing structure, to the edge and the
        // normal. It is tested like any other axis, so its rounding does not count.
        private function isBeside(corners:Vector.<Number>, p:int, q:int, r:int):Boolean
        {
            var px:Number = corners[p];
            var py:Number = corners[int(p + 1)];
            var pz:Number = corners[int(p + 2)];
            var ux:Number = corners[q] - px;
            var uy:Number = corners[int(q + 1)] - py;
            var uz:Number = corners[int(q + 2)] - pz;
            var x:Number = _along.y * uz - _along.z * uy;
            var y:Number = _along.z * ux - _along.x * uz;
            var z:Number = _along.x * uy - _along.y * ux;
            _across.x = x;
            _across.y = y;
            _across.z = z;
            _core.measure(_across);
            var reach:Number = _core.reach + _radius * Math.sqrt(x * x + y * y + z * z);
            var edge:Number = x * ux + y * uy + z * uz;
            var apex:Number = x * (corners[r] - px) + y * (corners[int(r + 1)] - py) + z * (corners[int(r + 2)] - pz);
            var low:Number = edge < 0 ? edge - reach : -reach;
            low = apex - reach < low ? apex - reach : low;
            var high:Number = edge > 0 ? edge + reach : reach;
            high = apex + reach > high ? apex + reach : high;
            var from:Number = x * (_core.x - px) + y * (_core.y - py) + z * (_core.z - pz);
            var to:Number = from + least * (x * _motion.x + y * _motion.y + z * _motion.z);
            if (from > high || from < low)
            {
                _startsApart = true;
                return from > high ? to > high : to < low;
            }
            return false;
        }
    }
}
