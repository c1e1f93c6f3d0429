package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Trigonometry;
    import starlogo.hierarchy.HierarchyNode;

    use namespace engine;

    /**
     * A model's triangles, for exact tests: their corners, and the inside of the surface that they make. A SolidBuilder makes it. The
     * triangles are in the hierarchy's order.
     */
    internal final class Solid
    {
        /** The number of points that partPoints has for each part. */
        public static const POINTS_PER_PART:int = 6;

        /** The directions in which rays are cast, one after the other. They are unrelated to the axes along which models are built. */
        public static const RAYS:Vector.<Number> = new <Number>[
                0.5391, 0.2718, 0.7972, -0.3473, 0.8651, 0.3618, 0.7113, -0.5897, -0.3826, -0.1937, -0.6329, 0.7496,
                0.8839, 0.4421, -0.1527, -0.6681, 0.1172, -0.7348, 0.0931, -0.9217, -0.3765, -0.8263, -0.4402, 0.3511];

        /** The triangles' corners: nine numbers each. */
        public var corners:Vector.<Number>;

        /** The triangles' extents: minX, minY, minZ, maxX, maxY, maxZ of each. */
        public var extents:Vector.<Number>;

        /**
         * The triangles' planes: x, y, z of the unit normal, the distance from the origin along the normal, and how far the triangle's own
         * corners are off the plane. For a triangle without area the normal is 0 and the last number is infinite.
         */
        public var planes:Vector.<Number>;

        /** Whether the surface is closed, so that it has an inside. */
        public var isClosed:Boolean = false;

        /** Whether all triangles have the same orientation. */
        public var isOriented:Boolean = false;

        /**
         * For each part of the surface, the vertices with the smallest and largest x, y and z. A part is connected, or its pieces touch
         * each other. So a part that does not touch another surface is inside or outside of it as a whole.
         */
        public var partPoints:Vector.<Number> = new Vector.<Number>();

        /** The extent of the smallest part: the longest of its three extents. */
        public var leastPartExtent:Number = Infinity;

        /** The widest gap in the surface's seams. */
        public var widestSeam:Number = 0;

        // The result of crossingOf for a ray that comes close to an edge, or begins close to the triangle.
        private static const UNCLEAR:int = 2;

        private var _root:HierarchyNode;

        // The origin and the direction of the current ray.
        private var _x:Number;
        private var _y:Number;
        private var _z:Number;
        private var _directionX:Number;
        private var _directionY:Number;
        private var _directionZ:Number;
        private var _crossings:int;
        private var _stack:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();

        /**
         * @param root the node around all triangles
         * @param count the number of triangles
         */
        public function Solid(root:HierarchyNode, count:int)
        {
            _root = root;
            corners = new Vector.<Number>(9 * count, true);
            extents = new Vector.<Number>(6 * count, true);
            planes = new Vector.<Number>(5 * count, true);
        }

        /**
         * Whether a point is inside of the surface. The point must not be on it. False if the surface is not closed. A ray is cast from the
         * point, and its crossings are counted. If every ray that is tried comes close to an edge, the solid angles of all triangles are
         * added up instead.
         */
        public function isInside(point:Vector3D):Boolean
        {
            var x:Number = point.x;
            var y:Number = point.y;
            var z:Number = point.z;
            var isOutOfReach:Boolean = Math.abs(x - _root.x) > _root.halfX || Math.abs(y - _root.y) > _root.halfY
                || Math.abs(z - _root.z) > _root.halfZ;
            if (isOutOfReach || !isClosed)
            {
                return false;
            }
            _x = x;
            _y = y;
            _z = z;
            for (var i:int = 0; i < RAYS.length; i += 3)
            {
                var dx:Number = RAYS[i];
                var dy:Number = RAYS[int(i + 1)];
                var dz:Number = RAYS[int(i + 2)];
                // Cast in the direction in which the box ends sooner.
                var isBackward:Boolean = (x - _root.x) * dx + (y - _root.y) * dy + (z - _root.z) * dz < 0;
                _directionX = isBackward ? -dx : dx;
                _directionY = isBackward ? -dy : dy;
                _directionZ = isBackward ? -dz : dz;
                if (countCrossings())
                {
                    return _crossings != 0;
                }
            }
            return Math.abs(windingAround(x, y, z)) > 0.5;
        }

        // Counts how often the surface winds around the ray's origin. For a surface that is not oriented, counts the parity of the
        // crossings. Returns false if the ray comes close to an edge.
        private function countCrossings():Boolean
        {
            var winding:int = 0;
            var parity:int = 0;
            var stack:Vector.<HierarchyNode> = _stack;
            stack[0] = _root;
            var top:int = 1;
            while (top > 0)
            {
                top--;
                var node:HierarchyNode = stack[top];
                if (!meetsBox(node))
                {
                    continue;
                }
                if (node.low != null)
                {
                    stack[top] = node.high;
                    stack[top + 1] = node.low;
                    top += 2;
                    continue;
                }
                var end:int = node.end;
                for (var i:int = node.first; i < end; i++)
                {
                    var crossing:int = crossingOf(9 * i);
                    if (crossing == UNCLEAR)
                    {
                        return false;
                    }
                    winding += crossing;
                    parity ^= crossing & 1;
                }
            }
            _crossings = isOriented ? winding : parity;
            return true;
        }

        // Tests separating axes: the box's axes, and the three directions perpendicular to the ray and an edge of the box. The box is
        // enlarged by a seam, because a ray through a seam's gap comes close to an edge.
        private function meetsBox(node:HierarchyNode):Boolean
        {
            var dx:Number = _directionX;
            var dy:Number = _directionY;
            var dz:Number = _directionZ;
            var fromX:Number = _x - node.x;
            var fromY:Number = _y - node.y;
            var fromZ:Number = _z - node.z;
            var halfX:Number = node.halfX + widestSeam;
            var halfY:Number = node.halfY + widestSeam;
            var halfZ:Number = node.halfZ + widestSeam;
            var aheadX:Number = dx > 0 ? fromX : -fromX;
            var aheadY:Number = dy > 0 ? fromY : -fromY;
            var aheadZ:Number = dz > 0 ? fromZ : -fromZ;
            if (aheadX > halfX || aheadY > halfY || aheadZ > halfZ)
            {
                return false;
            }
            var widthX:Number = dx < 0 ? -dx : dx;
            var widthY:Number = dy < 0 ? -dy : dy;
            var widthZ:Number = dz < 0 ? -dz : dz;
            var aside:Number = fromY * dz - fromZ * dy;
            var reach:Number = halfY * widthZ + halfZ * widthY;
            if (aside > reach || aside < -reach)
            {
                return false;
            }
            aside = fromZ * dx - fromX * dz;
            reach = halfZ * widthX + halfX * widthZ;
            if (aside > reach || aside < -reach)
            {
                return false;
            }
            aside = fromX * dy - fromY * dx;
            reach = halfX * widthY + halfY * widthX;
            return aside <= reach && aside >= -reach;
        }

        // Returns 1 if the ray leaves through the triangle's front, -1 if it enters, 0 if it does not cross the triangle, and UNCLEAR if it
        // comes close to an edge or begins close to the triangle. The signs of the triple products say on which side the ray passes the
        // edges.
        private function crossingOf(at:int):int
        {
            var x:Number = _x;
            var y:Number = _y;
            var z:Number = _z;
            var dx:Number = _directionX;
            var dy:Number = _directionY;
            var dz:Number = _directionZ;
            var points:Vector.<Number> = corners;
            var px:Number = points[at] - x;
            var py:Number = points[int(at + 1)] - y;
            var pz:Number = points[int(at + 2)] - z;
            var qx:Number = points[int(at + 3)] - x;
            var qy:Number = points[int(at + 4)] - y;
            var qz:Number = points[int(at + 5)] - z;
            var rx:Number = points[int(at + 6)] - x;
            var ry:Number = points[int(at + 7)] - y;
            var rz:Number = points[int(at + 8)] - z;
            var u:Number = dx * (qy * rz - qz * ry) + dy * (qz * rx - qx * rz) + dz * (qx * ry - qy * rx);
            var v:Number = dx * (ry * pz - rz * py) + dy * (rz * px - rx * pz) + dz * (rx * py - ry * px);
            var w:Number = dx * (py * qz - pz * qy) + dy * (pz * qx - px * qz) + dz * (px * qy - py * qx);
            // The ray must also stay away from a seam's gap.
            var radius:Number = _root.radius;
            var near:Number = Tolerances.GRAZING * radius;
            if (near < 2 * widestSeam)
            {
                near = 2 * widestSeam;
            }
            near *= radius;
            if ((u > near || v > near || w > near) && (u < -near || v < -near || w < -near))
            {
                return 0;
            }
            if (!(u > near && v > near && w > near || u < -near && v < -near && w < -near))
            {
                return UNCLEAR;
            }
            var volume:Number = px * (qy * rz - qz * ry) + py * (qz * rx - qx * rz) + pz * (qx * ry - qy * rx);
            var thin:Number = Tolerances.GRAZING * radius * radius * radius;
            if (volume <= thin && volume >= -thin)
            {
                return UNCLEAR;
            }
            if (volume > 0 != u > 0)
            {
                return 0;
            }
            return u > 0 ? 1 : -1;
        }

        // Van Oosterom and Strackee, "The solid angle of a plane triangle", IEEE Trans. Biomed. Eng. 30(2), 1983.
        private function windingAround(x:Number, y:Number, z:Number):Number
        {
            var sum:Number = 0;
            for (var at:int = 0; at < corners.length; at += 9)
            {
                var px:Number = corners[at] - x;
                var py:Number = corners[at + 1] - y;
                var pz:Number = corners[at + 2] - z;
                var qx:Number = corners[at + 3] - x;
                var qy:Number = corners[at + 4] - y;
                var qz:Number = corners[at + 5] - z;
                var rx:Number = corners[at + 6] - x;
                var ry:Number = corners[at + 7] - y;
                var rz:Number = corners[at + 8] - z;
                var p:Number = Math.sqrt(px * px + py * py + pz * pz);
                var q:Number = Math.sqrt(qx * qx + qy * qy + qz * qz);
                var r:Number = Math.sqrt(rx * rx + ry * ry + rz * rz);
                var volume:Number = px * (qy * rz - qz * ry) + py * (qz * rx - qx * rz) + pz * (qx * ry - qy * rx);
                sum += Trigonometry.arctangent(volume, p * q * r + (px * qx + py * qy + pz * qz) * r + (qx * rx + qy * ry + qz * rz) * p
                        + (rx * px + ry * py + rz * pz) * q);
            }
            return sum / 360;
        }
    }
}
