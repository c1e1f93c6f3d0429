package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.Zonotope;

    /** Axes along which a moving structure and a triangle may stay apart. They rule out most triangles before a time of impact is sought. */
    internal final class SweptAxes
    {
        // The structure's core, the radius around it, and its motion.
        private var _core:Zonotope;
        private var _radius:Number = 0;
        private var _motion:RelativeMotion;

        // Six numbers for each axis that does not depend on the triangle: the axis, the least place along it that the structure comes to, the
        // greatest place at time 0, and the speed along it, which is not negative. Then the end of these numbers.
        private var _axes:Vector.<Number> = new Vector.<Number>(36, true);
        private var _end:int = 0;

        private var _axis:Vector3D = new Vector3D();

        /**
         * Sets the structure. Its axes are along each of the core's segments, and across each segment and the motion; for a sphere or a capsule
         * also the part of the motion across the segment.
         *
         * @param core the structure's core; kept
         * @param radius around the core, with the tolerance and a margin for rounding
         * @param motion of the structure; kept
         */
        public function setTo(core:Zonotope, radius:Number, motion:RelativeMotion):void
        {
            _core = core;
            _radius = radius;
            _motion = motion;
            _end = 0;
            var along:Vector.<Number> = core.directions;
            var share:Number = core.end == 3 ? along[0] * motion.x + along[1] * motion.y + along[2] * motion.z : 0;
            for (var i:int = 0; i < core.end; i += 3)
            {
                var x:Number = along[i];
                var y:Number = along[int(i + 1)];
                var z:Number = along[int(i + 2)];
                addAxis(x, y, z);
                addAxis(y * motion.z - z * motion.y, z * motion.x - x * motion.z, x * motion.y - y * motion.x);
            }
            if (core.end < 9)
            {
                addAxis(motion.x - share * along[0], motion.y - share * along[1], motion.z - share * along[2]);
            }
        }

        private function addAxis(x:Number, y:Number, z:Number):void
        {
            var axes:Vector.<Number> = _axes;
            var at:int = _end;
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
            _end = at + 6;
        }

        /**
         * Whether an axis separates a triangle from the structure.
         *
         * @param corners has nine numbers of the triangle
         * @param at index of the first of them
         * @param until its <code>latest</code> is the time until which they are apart. It is in a record, because V8 makes objects for Numbers that
         *     are passed
         */
        public function areApart(corners:Vector.<Number>, at:int, until:RelativeMotion):Boolean
        {
            var axes:Vector.<Number> = _axes;
            var end:int = _end;
            var latest:Number = until.latest;
            for (var i:int = 0; i < end; i += 6)
            {
                var x:Number = axes[i];
                var y:Number = axes[int(i + 1)];
                var z:Number = axes[int(i + 2)];
                var p:Number = x * corners[at] + y * corners[int(at + 1)] + z * corners[int(at + 2)];
                var q:Number = x * corners[int(at + 3)] + y * corners[int(at + 4)] + z * corners[int(at + 5)];
                var r:Number = x * corners[int(at + 6)] + y * corners[int(at + 7)] + z * corners[int(at + 8)];
                var low:Number = axes[int(i + 3)];
                var high:Number = axes[int(i + 4)] + latest * axes[int(i + 5)];
                if (p < low && q < low && r < low || p > high && q > high && r > high)
                {
                    return true;
                }
            }
            return isBeside(corners, at, at + 3, at + 6, until) || isBeside(corners, at + 3, at + 6, at, until) || isBeside(corners, at + 6, at, at + 3, until);
        }

        // Whether the axis perpendicular to the motion and to the edge from p to q separates the two. It is tested like any other axis, so
        // its rounding does not count.
        private function isBeside(corners:Vector.<Number>, p:int, q:int, r:int, until:RelativeMotion):Boolean
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
            var to:Number = place + until.latest * speed;
            return from > high && to > high || from < low && to < low;
        }
    }
}
