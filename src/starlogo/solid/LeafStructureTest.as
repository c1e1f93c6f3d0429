package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.MovingBoxTraversal;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.ConvexTriangle;
    import starlogo.intersection.contact.Zonotope;

    use namespace engine;

    /**
     * Decides whether a triangle of a model's leaf touches a solid structure, or when it does so. The ground tests its triangles
     * by the same ConvexTriangle. If the structure moves, separating axes rule out most triangles before.
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
        private var _planes:Vector.<Number>;
        private var _motion:RelativeMotion;
        private var _sweep:RelativeMotion = new RelativeMotion();
        private var _test:ConvexTriangle = new ConvexTriangle();

        // The extents of the structure's core and of its motion: least x, greatest x, least y, ... The core of a round structure is a point
        // or a segment.
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // The structure's core, and the radius around it, with the gap across which it touches and a margin for rounding.
        private var _core:Zonotope = new Zonotope();
        private var _radius:Number = 0;

        // An axis that may separate the two.
        private var _axis:Vector3D = new Vector3D();

        // Whether a triangle is touched, and the index of the first number of the one that is touched first.
        private var _isFound:Boolean = false;
        private var _first:int = 0;
        private var _corner:Vector3D = new Vector3D();

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
            _isFound = false;
            _solid = model.facets;
            _motion = motion;
            _test.begin(structure, pose.placement);
            _test.shape.margin += pose.gap + Touching.marginOfSurface(model.tree.radius);
            _test.structure.extentsInto(_extents);
            var extents:Vector.<Number> = _extents;
            var gap:Number = _test.shape.margin;
            var halfX:Number = (extents[1] - extents[0]) / 2 + gap;
            var halfY:Number = (extents[3] - extents[2]) / 2 + gap;
            var halfZ:Number = (extents[5] - extents[4]) / 2 + gap;
            isCompact = 8 * halfX * halfY * halfZ <= COMPACT * _test.structure.volume;
            boxes.setPlace((extents[0] + extents[1]) / 2, (extents[2] + extents[3]) / 2, (extents[4] + extents[5]) / 2, 0);
            boxes.halfX = halfX;
            boxes.halfY = halfY;
            boxes.halfZ = halfZ;
            boxes.setMotion(motion.x, motion.y, motion.z);
            boxes.from = motion.earliest;
            var round:Number = _test.shape.radius;
            _radius = round + gap + Tolerances.EXTENTS * (halfX + halfY + halfZ);
            for (var i:int = 0; i < 6; i += 2)
            {
                extents[i] += round;
                extents[int(i + 1)] -= round;
            }
            least = 0;
            _planes = _solid.planes;
            _core.setTo(_test.structure, RelativeMotion.NONE);
            _sweep.x = motion.x;
            _sweep.y = motion.y;
            _sweep.z = motion.z;
            if (motion !== RelativeMotion.NONE)
            {
                least = motion.latest;
                prepareMotion();
            }
        }

        // Prepares what only a moving structure needs.
        private function prepareMotion():void
        {
            var motion:RelativeMotion = _motion;
            var margin:Number = Tolerances.EXTENTS * (boxes.halfX + boxes.halfY + boxes.halfZ + Math.abs(_core.x) + Math.abs(_core.y) + Math.abs(_core.z)
                    + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            _radius = _test.shape.radius + _test.shape.margin + margin;
            widen(0, motion.x);
            widen(2, motion.y);
            widen(4, motion.z);
            // A structure that stands is a question of its contact: the order of the pairs of boxes chooses among the triangles that it touches.
            isCompact &&= motion.x != 0 || motion.y != 0 || motion.z != 0;
            boxes.x = _core.x;
            boxes.y = _core.y;
            boxes.z = _core.z;
            boxes.halfX += margin;
            boxes.halfY += margin;
            boxes.halfZ += margin;
        }

        // Widens the extents along an axis to those of the motion from its earliest to its latest time. The way is the whole motion's.
        private function widen(axis:int, way:Number):void
        {
            var begin:Number = way * _motion.earliest;
            var end:Number = way * _motion.latest;
            var low:Number = begin < end ? begin : end;
            var high:Number = begin < end ? end : begin;
            _extents[axis] += low;
            _extents[int(axis + 1)] += high;
        }

        /** Searches the model. Returns whether a triangle is touched. If the structure moves, <code>least</code> becomes the time. */
        public function find():Boolean
        {
            boxes.find(_solid.tree, this);
            least = Math.max(0, least);
            return _isFound;
        }

        /** @inheritDoc */
        override public function touch(treeA:BoxTree, a:int, treeB:BoxTree, b:int):Boolean
        {
            var wasFound:Boolean = _isFound;
            var before:Number = least;
            look(treeA.first[a], treeA.end[a]);
            least = Math.max(0, least);
            return least < before || _isFound != wasFound;
        }

        /** @inheritDoc */
        override public function look(first:int, end:int):void
        {
            var isMoving:Boolean = _motion !== RelativeMotion.NONE;
            for (var i:int = first; i < end; i++)
            {
                if (squaredGap(_extents, _solid.corners, 9 * i) > _radius * _radius)
                {
                    continue;
                }
                findEarliest(i);
                if (_sweep.earliest > least || isMoving && isPassed(9 * i))
                {
                    continue;
                }
                triangleTests++;
                _test.setTriangle(_solid.corners, 9 * i);
                if (isMoving ? !isTouchedEarlier() : !_test.areTouching())
                {
                    continue;
                }
                _isFound = true;
                _first = 9 * i;
                if (!(least > 0))
                {
                    // no triangle can be touched earlier
                    least = -Infinity;
                    return;
                }
            }
        }

        // Whether the triangle of the test is touched earlier than all before. If so, the least time becomes its time.
        private function isTouchedEarlier():Boolean
        {
            _sweep.latest = least;
            _test.findTime(_sweep);
            var time:Number = _sweep.time;
            if (time < least || !_isFound && time == least)
            {
                least = time;
                return true;
            }
            return false;
        }

        /** @inheritDoc */
        override public function findContact(out:ContactPoint):void
        {
            _test.setTriangle(_solid.corners, _first);
            _sweep.time = _motion.time;
            _test.findContact(_sweep, out);
            out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
        }

        /**
         * If a corner of the triangle that is touched first is inside of a structure, writes it in place of both closest points. Only after a triangle
         * was touched.
         */
        public function takeCorner(structure:BoundingStructure, out:ClosestPoints):void
        {
            _corner.setTo(_solid.corners[_first], _solid.corners[int(_first + 1)], _solid.corners[int(_first + 2)]);
            if (structure.contains(_corner))
            {
                out.setPoint(_corner);
            }
        }

        // Finds when the structure first comes to a triangle's plane; it cannot touch the triangle before.
        private function findEarliest(triangle:int):void
        {
            var planes:Vector.<Number> = _planes;
            var at:int = 4 * triangle;
            _axis.x = planes[at];
            _axis.y = planes[int(at + 1)];
            _axis.z = planes[int(at + 2)];
            _core.measure(_axis);
            var reach:Number = _core.reach + _radius + _solid.flatness;
            var from:Number = _axis.x * _core.x + _axis.y * _core.y + _axis.z * _core.z - planes[int(at + 3)];
            var speed:Number = _axis.x * _motion.x + _axis.y * _motion.y + _axis.z * _motion.z;
            var gap:Number = from < 0 ? -from : from;
            gap -= reach;
            var closing:Number = from < 0 ? speed : -speed;
            var earliest:Number = _motion.earliest;
            if (gap > 0)
            {
                var time:Number = closing > 0 ? gap / closing : RelativeMotion.NEVER;
                earliest = time > earliest ? time : earliest;
            }
            _sweep.earliest = earliest;
        }

        // Whether an axis across the motion and an edge separates a triangle from the moving structure until <code>least</code>.
        private function isPassed(at:int):Boolean
        {
            var corners:Vector.<Number> = _solid.corners;
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
            var place:Number = x * (_core.x - px) + y * (_core.y - py) + z * (_core.z - pz);
            var way:Number = x * _motion.x + y * _motion.y + z * _motion.z;
            var from:Number = place + _motion.earliest * way;
            var to:Number = place + least * way;
            return from > high && to > high || from < low && to < low;
        }
    }
}
