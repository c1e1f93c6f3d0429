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

        // The edge and the axis that are added, and how far the core extends along the axis.
        private var _edge:Vector3D = new Vector3D();
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
            if (shape.coreKind == ConvexShape.POINT || shape.coreKind == ConvexShape.SEGMENT)
            {
                setEdgeTo(shape.pointsEnd - 3);
                addMotionAcrossEdge();
            }
            if (shape.areEdgesPerpendicular)
            {
                var edges:Vector.<int> = shape.edges;
                // the ends of the edges, which begin at the first point
                for (var i:int = 1; i < edges.length; i += 4)
                {
                    setEdgeTo(edges[i]);
                    addEdge();
                }
            }
            else if (shape.coreKind != ConvexShape.POINT)
            {
                _edge.setTo(1, 0, 0);
                addEdge();
                _edge.setTo(0, 1, 0);
                addEdge();
                _edge.setTo(0, 0, 1);
                addEdge();
            }
        }

        // Sets the edge to that from the shape's first point to another one.
        private function setEdgeTo(end:int):void
        {
            var points:Vector.<Number> = _shape.points;
            _edge.x = points[end] - points[0];
            _edge.y = points[int(end + 1)] - points[1];
            _edge.z = points[int(end + 2)] - points[2];
        }

        // Adds the part of the motion across the edge. It is all of the motion if the edge has no length.
        private function addMotionAcrossEdge():void
        {
            var motion:RelativeMotion = _motion;
            var edge:Vector3D = _edge;
            var squared:Number = edge.x * edge.x + edge.y * edge.y + edge.z * edge.z;
            var fraction:Number = squared > 0 ? (edge.x * motion.x + edge.y * motion.y + edge.z * motion.z) / squared : 0;
            _axis.x = motion.x - fraction * edge.x;
            _axis.y = motion.y - fraction * edge.y;
            _axis.z = motion.z - fraction * edge.z;
            addAxis();
        }

        // Adds the axis along the edge, and the one across the edge and the motion.
        private function addEdge():void
        {
            var motion:RelativeMotion = _motion;
            var edge:Vector3D = _edge;
            _axis.copyFrom(edge);
            addAxis();
            _axis.x = edge.y * motion.z - edge.z * motion.y;
            _axis.y = edge.z * motion.x - edge.x * motion.z;
            _axis.z = edge.x * motion.y - edge.y * motion.x;
            addAxis();
        }

        // Adds the axis, turned to the motion's side. The axis and the edge are fields, because V8 makes objects of Numbers that are passed.
        private function addAxis():void
        {
            var axes:Vector.<Number> = _axes;
            var at:int = _end;
            var axis:Vector3D = _axis;
            var shape:ConvexShape = _shape;
            var speed:Number = axis.x * _motion.x + axis.y * _motion.y + axis.z * _motion.z;
            if (speed < 0)
            {
                axis.negate();
                speed = -speed;
            }
            shape.project(axis, _ofShape);
            var radius:Number = cullDistance * Math.sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
            var origin:Number = axis.x * shape.origin.x + axis.y * shape.origin.y + axis.z * shape.origin.z;
            axes[at] = axis.x;
            axes[int(at + 1)] = axis.y;
            axes[int(at + 2)] = axis.z;
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
