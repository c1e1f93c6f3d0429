package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.Interval;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * Axes along which a moving shape and a triangle may stay apart. They rule out most triangles before a time of impact is sought. Most axes depend
     * on the shape and its motion, so all triangles share them. A sphere or a capsule also has those across the motion and an edge of the triangle.
     */
    internal final class SweptAxes
    {
        // How many numbers describe an axis: the axis itself; the least place along it that the shape comes to; the greatest one at time 0; how far the
        // shape moves along it until time 1, which is not negative.
        private static const PER_AXIS:int = 6;

        // The largest number of axes, which a box or a hull has: two for each of three directions. A capsule has three, a sphere one.
        private static const MAX_AXES:int = 6;

        /** How far the core may be from a triangle that the shape touches, with all that is rounded. Set it before the first triangle is tested. */
        public var cullDistance:Number = 0;

        private var _shape:ConvexShape = null;
        private var _motion:RelativeMotion = null;

        // The numbers of all axes, and their end.
        private var _axes:Vector.<Number> = new Vector.<Number>(PER_AXIS * MAX_AXES, true);
        private var _end:int = 0;

        // The axis that is added, and how far the core extends along it.
        private var _axis:Vector3D = new Vector3D();
        private var _ofShape:Interval = new Interval();

        /**
         * Sets the shape. Its axes are made for the first triangle that is tested: most motions come near none.
         *
         * @param shape kept
         * @param motion of the shape; kept. Its latest time may change from triangle to triangle
         */
        public function setTo(shape:ConvexShape, motion:RelativeMotion):void
        {
            _shape = shape;
            _motion = motion;
            _end = 0;
        }

        // Makes the axes. They are along each edge of a box or a segment, and across each edge and the motion; for a sphere or a capsule also the part
        // of the motion across the segment. For a hull, the coordinate axes stand for the edges.
        private function addAxes():void
        {
            var shape:ConvexShape = _shape;
            var motion:RelativeMotion = _motion;
            var points:Vector.<Number> = shape.points;
            if (shape.coreKind == ConvexShape.POINT)
            {
                addAxis(motion.x, motion.y, motion.z);
            }
            else if (shape.coreKind == ConvexShape.SEGMENT)
            {
                var x:Number = points[3] - points[0];
                var y:Number = points[4] - points[1];
                var z:Number = points[5] - points[2];
                var squared:Number = x * x + y * y + z * z;
                var fraction:Number = squared > 0 ? (x * motion.x + y * motion.y + z * motion.z) / squared : 0;
                addAxis(motion.x - fraction * x, motion.y - fraction * y, motion.z - fraction * z);
            }
            if (shape.areEdgesPerpendicular)
            {
                var edges:Vector.<int> = shape.edges;
                // the ends of the edges, which begin at the first point
                for (var i:int = 1; i < edges.length; i += 4)
                {
                    var end:int = edges[i];
                    addEdge(points[end] - points[0], points[int(end + 1)] - points[1], points[int(end + 2)] - points[2]);
                }
            }
            else if (shape.coreKind != ConvexShape.POINT)
            {
                addEdge(1, 0, 0);
                addEdge(0, 1, 0);
                addEdge(0, 0, 1);
            }
        }

        private function addEdge(x:Number, y:Number, z:Number):void
        {
            addAxis(x, y, z);
            addAxis(y * _motion.z - z * _motion.y, z * _motion.x - x * _motion.z, x * _motion.y - y * _motion.x);
        }

        private function addAxis(x:Number, y:Number, z:Number):void
        {
            var axes:Vector.<Number> = _axes;
            var at:int = _end;
            var sign:int = x * _motion.x + y * _motion.y + z * _motion.z < 0 ? -1 : 1;
            _axis.setTo(sign * x, sign * y, sign * z);
            _shape.project(_axis, _ofShape);
            var radius:Number = cullDistance * _axis.length;
            var origin:Number = _axis.x * _shape.origin.x + _axis.y * _shape.origin.y + _axis.z * _shape.origin.z;
            var speed:Number = _axis.x * _motion.x + _axis.y * _motion.y + _axis.z * _motion.z;
            axes[at] = _axis.x;
            axes[int(at + 1)] = _axis.y;
            axes[int(at + 2)] = _axis.z;
            axes[int(at + 3)] = origin + _ofShape.min - radius;
            axes[int(at + 4)] = origin + _ofShape.max + radius;
            axes[int(at + 5)] = speed;
            _end = at + PER_AXIS;
        }

        /**
         * Whether one of the axes separates a triangle from the shape until the motion's latest time. The first triangle makes the axes.
         *
         * @param corners nine numbers of the triangle
         */
        public function areApart(corners:Vector.<Number>):Boolean
        {
            if (_end == 0)
            {
                addAxes();
            }
            var axes:Vector.<Number> = _axes;
            var end:int = _end;
            var latest:Number = _motion.latestTime;
            for (var i:int = 0; i < end; i += PER_AXIS)
            {
                var x:Number = axes[i];
                var y:Number = axes[int(i + 1)];
                var z:Number = axes[int(i + 2)];
                var first:Number = x * corners[0] + y * corners[1] + z * corners[2];
                var second:Number = x * corners[3] + y * corners[4] + z * corners[5];
                var third:Number = x * corners[6] + y * corners[7] + z * corners[8];
                var low:Number = axes[int(i + 3)];
                var high:Number = axes[int(i + 4)] + latest * axes[int(i + 5)];
                if (first < low && second < low && third < low || first > high && second > high && third > high)
                {
                    return true;
                }
            }
            return (_shape.coreKind == ConvexShape.POINT || _shape.coreKind == ConvexShape.SEGMENT) && passesBeside(corners);
        }

        // Whether an axis across the motion and an edge separates a triangle from a point or a segment. The shape does not move along such an axis.
        private function passesBeside(corners:Vector.<Number>):Boolean
        {
            var shape:ConvexShape = _shape;
            var motion:RelativeMotion = _motion;
            var points:Vector.<Number> = shape.points;
            var lastPoint:int = shape.pointsEnd - 3;
            // the triangle's edge goes from one corner to the next, and the third one is opposite to it
            var from:int = 6;
            var opposite:int = 3;
            for (var to:int = 0; to < 9; to += 3)
            {
                var x:Number = corners[from] - shape.origin.x;
                var y:Number = corners[int(from + 1)] - shape.origin.y;
                var z:Number = corners[int(from + 2)] - shape.origin.z;
                var edgeX:Number = corners[to] - corners[from];
                var edgeY:Number = corners[int(to + 1)] - corners[int(from + 1)];
                var edgeZ:Number = corners[int(to + 2)] - corners[int(from + 2)];
                var acrossX:Number = motion.y * edgeZ - motion.z * edgeY;
                var acrossY:Number = motion.z * edgeX - motion.x * edgeZ;
                var acrossZ:Number = motion.x * edgeY - motion.y * edgeX;
                // where the edge, the opposite corner and the shape's first and last points are along the axis
                var edge:Number = acrossX * x + acrossY * y + acrossZ * z;
                var corner:Number = acrossX * (corners[opposite] - shape.origin.x) + acrossY * (corners[int(opposite + 1)] - shape.origin.y)
                    + acrossZ * (corners[int(opposite + 2)] - shape.origin.z);
                var start:Number = acrossX * points[0] + acrossY * points[1] + acrossZ * points[2];
                var end:Number = acrossX * points[lastPoint] + acrossY * points[int(lastPoint + 1)] + acrossZ * points[int(lastPoint + 2)];
                var low:Number = start < end ? start : end;
                var high:Number = start < end ? end : start;
                var gap:Number = edge < corner ? edge - high : low - edge;
                if (gap > 0)
                {
                    // rounding of products of the three vectors
                    gap -= Tolerances.EXTENTS * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z))
                        * (Math.abs(edgeX) + Math.abs(edgeY) + Math.abs(edgeZ)) * (Math.abs(x) + Math.abs(y) + Math.abs(z));
                    if (gap > cullDistance * Math.sqrt(acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ))
                    {
                        return true;
                    }
                }
                opposite = from;
                from = to;
            }
            return false;
        }
    }
}
