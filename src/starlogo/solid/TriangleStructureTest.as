package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.TriangleKernel;
    import starlogo.intersection.LeafTest;
    import starlogo.intersection.contact.Zonotope;

    use namespace engine;

    /**
     * Decides whether a triangle of a model's leaf touches a solid structure, or when it does so. The ground tests its triangles
     * by the same TriangleKernel. If the structure moves, separating axes rule out most triangles before.
     */
    internal final class TriangleStructureTest extends LeafTest
    {
        /** Finds the leaves near the structure's extents. */
        public var boxes:BoxSearch = new BoxSearch();

        /** The number of triangles tested. The caller sets it to 0. */
        public var triangleTests:int = 0;

        private var _mesh:TriangleMesh;
        private var _planes:Vector.<Number>;
        private var _motion:RelativeMotion;
        private var _sweep:RelativeMotion = new RelativeMotion();
        private var _test:TriangleKernel = new TriangleKernel();

        // The extents of the structure's core and of its motion: least x, greatest x, least y, ... The core of a round structure is a point
        // or a segment.
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // The structure's core, and the radius around it, with the tolerance and a margin for rounding.
        private var _core:Zonotope = new Zonotope();
        private var _radius:Number = 0;

        // Axes that may separate a triangle from the moving structure: six numbers each. They are the axis, the least place along it that the
        // structure comes to, the greatest place at time 0, and the speed along it, which is not negative. Then the end of these numbers.
        private var _axes:Vector.<Number> = new Vector.<Number>(36, true);
        private var _axesEnd:int = 0;

        // An axis that may separate the two.
        private var _axis:Vector3D = new Vector3D();

        // Whether a triangle is touched, and the index of the first number of the one that is touched first.
        private var _isFound:Boolean = false;
        private var _first:int = 0;

        /**
         * Whether a triangle of a model touches a structure.
         *
         * @param model the model; has triangles
         * @param structure in the space of another model
         * @param pose the other model's pose in the first one's space
         */
        public function areTouching(model:ModelTree, structure:BoundingStructure, pose:RelativePose):Boolean
        {
            begin(model, structure, pose, RelativeMotion.NONE);
            least = 0;
            boxes.find(_mesh.tree, int.MAX_VALUE, this);
            return _isFound;
        }

        /**
         * Finds when a moving structure first touches a triangle of a model. The parameters are those of <code>areTouching()</code>. The pose's
         * motion, which must not be RelativeMotion.NONE and is kept, receives the time.
         */
        public function findTime(model:ModelTree, structure:BoundingStructure, pose:RelativePose):void
        {
            begin(model, structure, pose, pose.motion);
            prepareMotion();
            least = _motion.latest;
            boxes.find(_mesh.tree, int.MAX_VALUE, this);
            var time:Number = least > 0 ? least : 0;
            _motion.time = _isFound ? time : RelativeMotion.NEVER;
        }

        private function begin(model:ModelTree, structure:BoundingStructure, pose:RelativePose, motion:RelativeMotion):void
        {
            _isFound = false;
            _mesh = model.mesh;
            _motion = motion;
            _test.setStructure(structure, pose.placement);
            _test.shape.margin += pose.tolerance + Touching.marginOfSurface(model.tree.radius);
            _test.structure.extentsInto(_extents);
            var extents:Vector.<Number> = _extents;
            var margin:Number = _test.shape.margin;
            boxes.setExtents(extents, margin);
            boxes.setMotion(motion);
            var round:Number = _test.shape.radius;
            _radius = round + margin + Tolerances.EXTENTS * (boxes.halfX + boxes.halfY + boxes.halfZ);
            for (var i:int = 0; i < 6; i += 2)
            {
                extents[i] += round;
                extents[int(i + 1)] -= round;
            }
            _planes = _mesh.planes;
            _core.setTo(_test.structure, RelativeMotion.NONE);
            _sweep.x = motion.x;
            _sweep.y = motion.y;
            _sweep.z = motion.z;
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
            boxes.x = _core.x;
            boxes.y = _core.y;
            boxes.z = _core.z;
            boxes.halfX += margin;
            boxes.halfY += margin;
            boxes.halfZ += margin;
            // along each of the core's segments, and across it; for a sphere or a capsule also along the motion across the segment
            var along:Vector.<Number> = _core.directions;
            var share:Number = _core.end == 3 ? along[0] * motion.x + along[1] * motion.y + along[2] * motion.z : 0;
            _axesEnd = 0;
            for (var i:int = 0; i < _core.end; i += 3)
            {
                var x:Number = along[i];
                var y:Number = along[int(i + 1)];
                var z:Number = along[int(i + 2)];
                addAxis(x, y, z);
                addAxis(y * motion.z - z * motion.y, z * motion.x - x * motion.z, x * motion.y - y * motion.x);
            }
            if (_core.end < 9)
            {
                addAxis(motion.x - share * along[0], motion.y - share * along[1], motion.z - share * along[2]);
            }
        }

        private function addAxis(x:Number, y:Number, z:Number):void
        {
            var axes:Vector.<Number> = _axes;
            var at:int = _axesEnd;
            var side:int = x * _motion.x + y * _motion.y + z * _motion.z < 0 ? -1 : 1;
            _axis.setTo(side * x, side * y, side * z);
            _core.measure(_axis);
            var radius:Number = _core.projectedRadius + _radius * _axis.length;
            var middle:Number = _axis.x * _core.x + _axis.y * _core.y + _axis.z * _core.z;
            var speed:Number = _axis.x * _motion.x + _axis.y * _motion.y + _axis.z * _motion.z;
            axes[at] = _axis.x;
            axes[int(at + 1)] = _axis.y;
            axes[int(at + 2)] = _axis.z;
            axes[int(at + 3)] = middle - radius + _motion.earliest * speed;
            axes[int(at + 4)] = middle + radius;
            axes[int(at + 5)] = speed;
            _axesEnd = at + 6;
        }

        // Widens the extents along an axis to those of the motion from its earliest to its latest time. The displacement is the whole motion's.
        private function widen(axis:int, displacement:Number):void
        {
            var begin:Number = displacement * _motion.earliest;
            var end:Number = displacement * _motion.latest;
            var low:Number = begin < end ? begin : end;
            var high:Number = begin < end ? end : begin;
            _extents[axis] += low;
            _extents[int(axis + 1)] += high;
        }

        /** @inheritDoc */
        override public function testLeaf(node:int, first:int, end:int):void
        {
            var isMoving:Boolean = _motion !== RelativeMotion.NONE;
            for (var i:int = first; i < end; i++)
            {
                if (squaredDistanceToExtents(_extents, _mesh.corners, 9 * i) > _radius * _radius)
                {
                    continue;
                }
                findEarliest(i);
                if (_sweep.earliest > least || isMoving && isPassed(9 * i))
                {
                    continue;
                }
                triangleTests++;
                _test.setTriangle(_mesh.corners, 9 * i);
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

        /**
         * Finds the contact of the triangle that is touched first, at the motion's time. It is in the model's space.
         *
         * @param out receives the contact, with a normal from the structure to the triangle
         */
        public function findContact(out:ContactPoint):void
        {
            _test.setTriangle(_mesh.corners, _first);
            _sweep.time = _motion.time;
            _test.findContact(_sweep, out);
            out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
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
            var radius:Number = _core.projectedRadius + _radius + _mesh.flatness;
            var from:Number = _axis.x * _core.x + _axis.y * _core.y + _axis.z * _core.z - planes[int(at + 3)];
            var speed:Number = _axis.x * _motion.x + _axis.y * _motion.y + _axis.z * _motion.z;
            var distance:Number = from < 0 ? -from : from;
            distance -= radius;
            var closing:Number = from < 0 ? speed : -speed;
            var earliest:Number = _motion.earliest;
            if (distance > 0)
            {
                var time:Number = closing > 0 ? distance / closing : RelativeMotion.NEVER;
                earliest = time > earliest ? time : earliest;
            }
            _sweep.earliest = earliest;
        }

        // Whether an axis separates a triangle from the moving structure until <code>least</code>.
        private function isPassed(at:int):Boolean
        {
            var corners:Vector.<Number> = _mesh.corners;
            var axes:Vector.<Number> = _axes;
            var end:int = _axesEnd;
            for (var i:int = 0; i < end; i += 6)
            {
                var x:Number = axes[i];
                var y:Number = axes[int(i + 1)];
                var z:Number = axes[int(i + 2)];
                var p:Number = x * corners[at] + y * corners[int(at + 1)] + z * corners[int(at + 2)];
                var q:Number = x * corners[int(at + 3)] + y * corners[int(at + 4)] + z * corners[int(at + 5)];
                var r:Number = x * corners[int(at + 6)] + y * corners[int(at + 7)] + z * corners[int(at + 8)];
                var low:Number = axes[int(i + 3)];
                var high:Number = axes[int(i + 4)] + least * axes[int(i + 5)];
                if (p < low && q < low && r < low || p > high && q > high && r > high)
                {
                    return true;
                }
            }
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
            var radius:Number = _core.projectedRadius + _radius * Math.sqrt(x * x + y * y + z * z);
            var edge:Number = x * ux + y * uy + z * uz;
            var apex:Number = x * (corners[r] - px) + y * (corners[int(r + 1)] - py) + z * (corners[int(r + 2)] - pz);
            var low:Number = edge < 0 ? edge - radius : -radius;
            low = apex - radius < low ? apex - radius : low;
            var high:Number = edge > 0 ? edge + radius : radius;
            high = apex + radius > high ? apex + radius : high;
            var place:Number = x * (_core.x - px) + y * (_core.y - py) + z * (_core.z - pz);
            var speed:Number = x * _motion.x + y * _motion.y + z * _motion.z;
            var from:Number = place + _motion.earliest * speed;
            var to:Number = place + least * speed;
            return from > high && to > high || from < low && to < low;
        }
    }
}
