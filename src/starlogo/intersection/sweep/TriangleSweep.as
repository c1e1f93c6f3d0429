package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.Polygon;

    /**
     * When triangles that pass each other touch, and where: separating axes over time (see BoxSweep).
     *
     * <p>The axes are those of triangleTriangle, and like there each is projected on in full, so that needles and nearly parallel
     * edges need no cases of their own; of two triangles without area, the longest edges count. Allocates nothing.</p>
     *
     * @private
     */
    public final class TriangleSweep
    {
        private var _times:TouchingTimes = new TouchingTimes();
        private var _way:RelativeMotion = new RelativeMotion();
        private var _segmentA:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);
        private var _segmentB:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);
        private var _polygonA:Polygon = new Polygon();
        private var _polygonB:Polygon = new Polygon();

        // The corners of both, from a's first: a's second and third, b's three.
        private var _ux:Number;
        private var _uy:Number;
        private var _uz:Number;
        private var _vx:Number;
        private var _vy:Number;
        private var _vz:Number;
        private var _px:Number;
        private var _py:Number;
        private var _pz:Number;
        private var _qx:Number;
        private var _qy:Number;
        private var _qz:Number;
        private var _rx:Number;
        private var _ry:Number;
        private var _rz:Number;

        // Their edges, and the normals.
        private var _edgesA:Vector.<Number> = new Vector.<Number>(9, true);
        private var _edgesB:Vector.<Number> = new Vector.<Number>(9, true);

        private var _wayX:Number;
        private var _wayY:Number;
        private var _wayZ:Number;
        private var _tolerance:Number;

        // Whether axes are tried for the shortest way out rather than for the time; and that.
        private var _seeksDepth:Boolean;
        private var _depth:Number;
        private var _x:Number;
        private var _y:Number;
        private var _z:Number;

        /** No triangles yet. */
        public function TriangleSweep()
        {
        }

        /**
         * When two triangles touch for the first time.
         *
         * @param a has nine numbers of the one: x, y, z of each corner
         * @param atA where in a they begin
         * @param b has nine numbers of the other, where it is at time 0, in the same space
         * @param atB where in b they begin
         * @param wayX the way of b between times 0 and 1
         * @param wayY likewise
         * @param wayZ likewise
         * @param tolerance the gap that still counts as touching, a distance
         * @param latest the latest time that is of interest
         * @return from 0 to the latest time, or RelativeMotion.NEVER
         */
        public function touch(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int, wayX:Number, wayY:Number, wayZ:Number,
                tolerance:Number, latest:Number):Number
        {
            _seeksDepth = false;
            _times.begin(latest);
            _wayX = wayX;
            _wayY = wayY;
            _wayZ = wayZ;
            _tolerance = tolerance;
            take(a, atA, b, atB);
            return areSeparated() ? RelativeMotion.NEVER : _times.first;
        }

        /**
         * Where two triangles touch: the direction, at right angles to one or to an edge of each, along which they overlap least.
         *
         * @param a as in touch
         * @param atA as in touch
         * @param b as in touch
         * @param atB as in touch
         * @param wayX how far b is displaced
         * @param wayY likewise
         * @param wayZ likewise
         * @param out takes it, the normal pointing from b to a
         */
        public function findContact(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int, wayX:Number, wayY:Number, wayZ:Number,
                out:ContactPoint):void
        {
            _seeksDepth = true;
            _depth = Infinity;
            _x = _y = 0;
            _z = 1;
            take(a, atA, b, atB);
            _px += wayX;
            _py += wayY;
            _pz += wayZ;
            _qx += wayX;
            _qy += wayY;
            _qz += wayZ;
            _rx += wayX;
            _ry += wayY;
            _rz += wayZ;
            areSeparated();
            out.normalX = _x;
            out.normalY = _y;
            out.normalZ = _z;
            takeSupport(_polygonA, 0, 0, 0, _ux, _uy, _uz, _vx, _vy, _vz, -_x, -_y, -_z);
            takeSupport(_polygonB, _px, _py, _pz, _qx, _qy, _qz, _rx, _ry, _rz, _x, _y, _z);
            _polygonA.findCommonPoint(_polygonB, _x, _y, _z);
            out.depth = _depth > 0 && _depth < Infinity ? _depth : 0;
            out.x = a[atA] + _polygonA.x;
            out.y = a[int(atA + 1)] + _polygonA.y;
            out.z = a[int(atA + 2)] + _polygonA.z;
        }

        private function take(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int):void
        {
            var x:Number = a[atA];
            var y:Number = a[int(atA + 1)];
            var z:Number = a[int(atA + 2)];
            _ux = a[int(atA + 3)] - x;
            _uy = a[int(atA + 4)] - y;
            _uz = a[int(atA + 5)] - z;
            _vx = a[int(atA + 6)] - x;
            _vy = a[int(atA + 7)] - y;
            _vz = a[int(atA + 8)] - z;
            _px = b[atB] - x;
            _py = b[int(atB + 1)] - y;
            _pz = b[int(atB + 2)] - z;
            _qx = b[int(atB + 3)] - x;
            _qy = b[int(atB + 4)] - y;
            _qz = b[int(atB + 5)] - z;
            _rx = b[int(atB + 6)] - x;
            _ry = b[int(atB + 7)] - y;
            _rz = b[int(atB + 8)] - z;
        }

        private function areSeparated():Boolean
        {
            var nx:Number = _uy * _vz - _uz * _vy;
            var ny:Number = _uz * _vx - _ux * _vz;
            var nz:Number = _ux * _vy - _uy * _vx;
            if (isAxis(nx, ny, nz))
            {
                return true;
            }
            var edgesA:Vector.<Number> = _edgesA;
            var edgesB:Vector.<Number> = _edgesB;
            setEdges(edgesA, _ux, _uy, _uz, _vx, _vy, _vz);
            setEdges(edgesB, _qx - _px, _qy - _py, _qz - _pz, _rx - _px, _ry - _py, _rz - _pz);
            var mx:Number = edgesB[1] * edgesB[5] - edgesB[2] * edgesB[4];
            var my:Number = edgesB[2] * edgesB[3] - edgesB[0] * edgesB[5];
            var mz:Number = edgesB[0] * edgesB[4] - edgesB[1] * edgesB[3];
            if (isAxis(mx, my, mz))
            {
                return true;
            }
            var longestA:Number = longest(edgesA);
            var longestB:Number = longest(edgesB);
            var areaA:Number = nx * nx + ny * ny + nz * nz;
            var areaB:Number = mx * mx + my * my + mz * mz;
            var isFlatA:Boolean = areaA <= Tolerances.FLAT_TRIANGLE * longestA * longestA;
            var isFlatB:Boolean = areaB <= Tolerances.FLAT_TRIANGLE * longestB * longestB;
            if (isFlatA && isFlatB && !_seeksDepth)
            {
                return areSegmentsSeparated();
            }
            for (var i:int = 0; i < 9; i += 3)
            {
                var ex:Number = edgesA[i];
                var ey:Number = edgesA[int(i + 1)];
                var ez:Number = edgesA[int(i + 2)];
                for (var k:int = 0; k < 9; k += 3)
                {
                    var fx:Number = edgesB[k];
                    var fy:Number = edgesB[int(k + 1)];
                    var fz:Number = edgesB[int(k + 2)];
                    if (isAxis(ey * fz - ez * fy, ez * fx - ex * fz, ex * fy - ey * fx))
                    {
                        return true;
                    }
                }
            }
            // In the plane of the one whose normal is the more precise.
            if (isFlatA || (!isFlatB && areaA * longestB * longestB < areaB * longestA * longestA))
            {
                nx = mx;
                ny = my;
                nz = mz;
            }
            return isAxisInPlane(edgesA, nx, ny, nz) || isAxisInPlane(edgesB, nx, ny, nz);
        }

        private function isAxisInPlane(edges:Vector.<Number>, nx:Number, ny:Number, nz:Number):Boolean
        {
            for (var i:int = 0; i < 9; i += 3)
            {
                var x:Number = edges[i];
                var y:Number = edges[int(i + 1)];
                var z:Number = edges[int(i + 2)];
                if (isAxis(y * nz - z * ny, z * nx - x * nz, x * ny - y * nx))
                {
                    return true;
                }
            }
            return false;
        }

        // Whether a direction, of any length, separates the two all the time.
        private function isAxis(x:Number, y:Number, z:Number):Boolean
        {
            var u:Number = x * _ux + y * _uy + z * _uz;
            var v:Number = x * _vx + y * _vy + z * _vz;
            var p:Number = x * _px + y * _py + z * _pz;
            var q:Number = x * _qx + y * _qy + z * _qz;
            var r:Number = x * _rx + y * _ry + z * _rz;
            var low:Number = u < 0 ? u : 0;
            low = v < low ? v : low;
            var high:Number = u > 0 ? u : 0;
            high = v > high ? v : high;
            var lowB:Number = p < q ? p : q;
            lowB = r < lowB ? r : lowB;
            var highB:Number = p > q ? p : q;
            highB = r > highB ? r : highB;
            var at:Number = (lowB + highB - low - high) / 2;
            var reach:Number = (high - low + highB - lowB) / 2;
            if (_seeksDepth)
            {
                tryDepth(x, y, z, at, reach);
                return false;
            }
            var gap:Number = _tolerance * Math.sqrt(x * x + y * y + z * z);
            return _times.areSeparated(at, x * _wayX + y * _wayY + z * _wayZ, reach, gap);
        }

        private function tryDepth(x:Number, y:Number, z:Number, at:Number, reach:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            var depth:Number = (reach - Math.abs(at)) / length;
            // false for NaN
            if (depth < _depth - Tolerances.ROUNDING * reach / length)
            {
                var side:Number = at > 0 ? -1 : 1;
                _depth = depth;
                _x = side * x / length;
                _y = side * y / length;
                _z = side * z / length;
            }
        }

        private function areSegmentsSeparated():Boolean
        {
            setLongestEdge(_segmentA, _edgesA, 0, 0, 0);
            setLongestEdge(_segmentB, _edgesB, _px, _py, _pz);
            _segmentA.radius = _tolerance;
            _way.startX = _way.startY = _way.startZ = 0;
            _way.x = _wayX;
            _way.y = _wayY;
            _way.z = _wayZ;
            var time:Number = capsuleCapsuleImpact(_segmentB, _segmentA, _way);
            return !_times.limitTo(time);
        }

        private static function setEdges(edges:Vector.<Number>, ux:Number, uy:Number, uz:Number, vx:Number, vy:Number, vz:Number):void
        {
            edges[0] = ux;
            edges[1] = uy;
            edges[2] = uz;
            edges[3] = vx;
            edges[4] = vy;
            edges[5] = vz;
            edges[6] = vx - ux;
            edges[7] = vy - uy;
            edges[8] = vz - uz;
        }

        // The squared length of the longest edge.
        private static function longest(edges:Vector.<Number>):Number
        {
            var most:Number = 0;
            for (var i:int = 0; i < 9; i += 3)
            {
                var x:Number = edges[i];
                var y:Number = edges[int(i + 1)];
                var z:Number = edges[int(i + 2)];
                var squared:Number = x * x + y * y + z * z;
                most = squared > most ? squared : most;
            }
            return most;
        }

        // From a triangle's first corner on: the third edge begins where the first ends.
        private static function setLongestEdge(segment:Capsule, edges:Vector.<Number>, x:Number, y:Number, z:Number):void
        {
            var most:Number = longest(edges);
            var at:int = 0;
            while (at < 6 && edges[at] * edges[at] + edges[int(at + 1)] * edges[int(at + 1)] + edges[int(at + 2)] * edges[int(at + 2)] < most)
            {
                at += 3;
            }
            segment.start.setTo(at == 6 ? x + edges[0] : x, at == 6 ? y + edges[1] : y, at == 6 ? z + edges[2] : z);
            segment.end.setTo(segment.start.x + edges[at], segment.start.y + edges[int(at + 1)], segment.start.z + edges[int(at + 2)]);
        }

        // The corners of a triangle that are farthest out in a direction.
        private static function takeSupport(polygon:Polygon, px:Number, py:Number, pz:Number, qx:Number, qy:Number, qz:Number,
                rx:Number, ry:Number, rz:Number, x:Number, y:Number, z:Number):void
        {
            var p:Number = px * x + py * y + pz * z;
            var q:Number = qx * x + qy * y + qz * z;
            var r:Number = rx * x + ry * y + rz * z;
            var far:Number = p > q ? p : q;
            far = r > far ? r : far;
            far -= Tolerances.DIRECTION * (Math.abs(px - qx) + Math.abs(py - qy) + Math.abs(pz - qz) + Math.abs(px - rx)
                    + Math.abs(py - ry) + Math.abs(pz - rz));
            polygon.clear();
            if (p >= far)
            {
                polygon.add(px, py, pz);
            }
            if (q >= far)
            {
                polygon.add(qx, qy, qz);
            }
            if (r >= far)
            {
                polygon.add(rx, ry, rz);
            }
        }
    }
}
