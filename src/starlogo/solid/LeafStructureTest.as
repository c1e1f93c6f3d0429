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
     * Decides whether a triangle of a model's leaf touches a solid sphere, capsule or box, when it does so, or how far the two are apart.
     * The ground tests its triangles by the same ConvexTriangle. If the structure moves, separating axes rule out most triangles before.
     */
    internal final class LeafStructureTest extends LeafTest
    {
        // The extents of a compact structure have at most this many times its volume. Those of a sphere have 1.91 times.
        private static const COMPACT:Number = 2;

        /**
         * Whether the structure fills much of its extents, because it is not long and slanted. Then <code>find()</code> finds the leaves
         * faster than a traversal that knows its axes.
         */
        public var isCompact:Boolean = false;

        /** Finds the leaves near the structure's extents. */
        public var boxes:MovingBoxTraversal = new MovingBoxTraversal();

        private var _solid:Solid;
        private var _planes:Vector.<Number>; // set if the structure moves
        private var _isMeasuring:Boolean = false;
        private var _motion:RelativeMotion;
        private var _test:ConvexTriangle = new ConvexTriangle();

        // The extents of the structure's core and of its motion: least x, greatest x, least y, ... The core of a round structure is a point
        // or a segment. To measure distances, they are those of the whole structure.
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // The structure's core, and the radius around it, with a margin for rounding: the kernels find a touch a little beyond it.
        private var _core:Zonotope = new Zonotope();
        private var _radius:Number = 0;

        // An axis, and whether one that was tried for a triangle separates the two at the beginning.
        private var _axis:Vector3D = new Vector3D();
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
         * @param pose the other model's pose in the first one's space, and its motion from there, which is kept
         */
        public function begin(model:SolidHierarchy, structure:BoundingStructure, pose:RelativePose):void
        {
            var motion:RelativeMotion = pose.motion;
            _isMeasuring = _isFound = false;
            _test.margin = pose.gap + Tolerances.SURFACES * model.root.radius;
            place(model, structure, pose);
            _startsApart = false;
            var extents:Vector.<Number> = _extents;
            var halfX:Number = (extents[1] - extents[0]) / 2;
            var halfY:Number = (extents[3] - extents[2]) / 2;
            var halfZ:Number = (extents[5] - extents[4]) / 2;
            isCompact = 8 * halfX * halfY * halfZ <= COMPACT * _test.structure.volume;
            boxes.setPlace(extents[0] + halfX, extents[2] + halfY, extents[4] + halfZ, 0);
            boxes.halfX = halfX;
            boxes.halfY = halfY;
            boxes.halfZ = halfZ;
            boxes.setMotion(motion.x, motion.y, motion.z);
            var round:Number = _test.radius;
            _radius = round + Tolerances.EXTENTS * (halfX + halfY + halfZ);
            for (var i:int = 0; i < 6; i += 2)
            {
                extents[i] += round;
                extents[int(i + 1)] -= round;
            }
            least = 0;
            if (motion !== RelativeMotion.NONE)
            {
                least = 1;
                prepareMotion();
            }
        }

        // Prepares what only a moving structure needs.
        private function prepareMotion():void
        {
            var motion:RelativeMotion = _motion;
            _planes = _solid.planes;
            _core.setTo(_test.structure, RelativeMotion.NONE);
            var extents:Vector.<Number> = _extents;
            var margin:Number = Tolerances.EXTENTS * (boxes.halfX + boxes.halfY + boxes.halfZ + Math.abs(_core.x) + Math.abs(_core.y) + Math.abs(_core.z)
                    + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            _radius = _test.radius + margin;
            extents[0] += Math.min(motion.x, 0);
            extents[1] += Math.max(motion.x, 0);
            extents[2] += Math.min(motion.y, 0);
            extents[3] += Math.max(motion.y, 0);
            extents[4] += Math.min(motion.z, 0);
            extents[5] += Math.max(motion.z, 0);
            // A structure that stands is a question of its contact: the order of the pairs of boxes chooses among the triangles that it touches.
            isCompact &&= motion.x != 0 || motion.y != 0 || motion.z != 0;
            boxes.x = _core.x;
            boxes.y = _core.y;
            boxes.z = _core.z;
            boxes.halfX += margin;
            boxes.halfY += margin;
            boxes.halfZ += margin;
        }

        /** Searches the model. Returns whether a triangle is touched. If the structure moves, <code>least</code> becomes the time. */
        public function find():Boolean
        {
            boxes.find(_solid.tree, this);
            least = Math.max(0, least);
            return _isFound;
        }

        /** Begins to measure the distance from a model that has triangles. The parameters are those of <code>begin()</code>. */
        public function beginDistance(model:SolidHierarchy, structure:BoundingStructure, pose:RelativePose):void
        {
            _isMeasuring = true;
            _test.margin = 0;
            place(model, structure, pose);
        }

        /** @inheritDoc */
        override public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            if (_isMeasuring)
            {
                return isNearer(a);
            }
            var wasFound:Boolean = _isFound;
            var before:Number = least;
            look(a.first, a.end);
            least = Math.max(0, least);
            return least < before || _isFound != wasFound;
        }

        /** @inheritDoc */
        override public function look(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                if (squaredGap(i) > _radius * _radius || _motion !== RelativeMotion.NONE && isApart(i))
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
                out.setPoint(_corner);
            }
        }

        private function place(model:SolidHierarchy, structure:BoundingStructure, pose:RelativePose):void
        {
            _solid = model.facets;
            _motion = pose.motion;
            _test.begin(structure, pose.placement, _motion);
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

        // The squared distance of a triangle's extents from the extents of the structure.
        private function squaredGap(triangle:int):Number
        {
            var corners:Vector.<Number> = _solid.corners;
            var at:int = 9 * triangle;
            var squared:Number = 0;
            for (var axis:int = 0; axis < 6; axis += 2)
            {
                var p:Number = corners[at];
                var q:Number = corners[int(at + 3)];
                var r:Number = corners[int(at + 6)];
                var low:Number = _extents[axis];
                var high:Number = _extents[int(axis + 1)];
                var gap:Number = 0;
                if (p > high && q > high && r > high)
                {
                    gap = p < q ? p : q;
                    gap = gap < r ? gap : r;
                    gap -= high;
                }
                else if (p < low && q < low && r < low)
                {
                    gap = p > q ? p : q;
                    gap = gap > r ? gap : r;
                    gap = low - gap;
                }
                squared += gap * gap;
                at++;
            }
            return squared;
        }

        // Whether an axis separates a triangle from the moving structure until <code>least</code>: the normal of the triangle, or an axis
        // across the motion and an edge.
        private function isApart(triangle:int):Boolean
        {
            var planes:Vector.<Number> = _planes;
            var at:int = 4 * triangle;
            _axis.x = planes[at];
            _axis.y = planes[int(at + 1)];
            _axis.z = planes[int(at + 2)];
            _core.measure(_axis);
            var reach:Number = _core.reach + _radius + _solid.flatness;
            var from:Number = _axis.x * _core.x + _axis.y * _core.y + _axis.z * _core.z - planes[int(at + 3)];
            var to:Number = from + least * (_axis.x * _motion.x + _axis.y * _motion.y + _axis.z * _motion.z);
            // mirrored, so that the structure begins on the side of the normal
            if (from < 0)
            {
                from = -from;
                to = -to;
            }
            _startsApart = from > reach;
            if (_startsApart && to > reach)
            {
                return true;
            }
            var corners:Vector.<Number> = _solid.corners;
            at = 9 * triangle;
            return isBeside(corners, at, at + 3, at + 6) || isBeside(corners, at + 3, at + 6, at) || isBeside(corners, at + 6, at, at + 3);
        }

        // Whether the axis perpendicular to the motion and to the edge from p to q separates the two. It is tested like any other axis, so
        // its rounding does not count.
        private function isBeside(corners:Vector.<Number>, p:int, q:int, r:int):Boolean
        {
            var px:Number = corners[p];
            var py:Number = corners[int(p + 1)];
            var pz:Number = corners[int(p + 2)];
            var ux:Number = corners[q] - px;
            var uy:Number = corners[int(q + 1)] - py;
            var uz:Number = corners[int(q + 2)] - pz;
            var x:Number = _motion.y * uz - _motion.z * uy;
            var y:Number = _motion.z * ux - _motion.x * uz;
            var z:Number = _motion.x * uy - _motion.y * ux;
            _axis.x = x;
            _axis.y = y;
            _axis.z = z;
            _core.measure(_axis);
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
