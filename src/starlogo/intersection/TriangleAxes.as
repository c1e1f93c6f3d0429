// This file is long because all that an axis is computed from is in fields of its own: V8 makes objects of Numbers that are passed.
package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.TouchingTimes;

    /**
     * The kernel of two triangles: separating axes, all of them. The two normals, the nine cross products of an edge of each, and for
     * triangles that are nearly in one plane the six directions in it at right angles to an edge (Ericson, "Real-Time
     * Collision Detection", §5.2.1).
     *
     * <p>Each is projected on in full: however short and imprecise an axis is, it separates only triangles that have a gap, so
     * that nearly parallel edges and needle-like triangles need no cases of their own. A triangle without area is a segment or
     * a point; of two of them, the longest edges are compared. Here an axis separates triangles that stand still; TriangleSweep asks of
     * each for how long it does, or how deep they overlap.</p>
     *
     * @private
     */
    public class TriangleAxes
    {
        /** Whether triangles stand, and no contact is looked for. */
        protected var isStanding:Boolean = true;

        /** Between what the projections on an axis are, and when it separates triangles that pass each other. */
        protected var times:TouchingTimes;

        /** How the second moves then. */
        protected var motion:RelativeMotion;

        /** The gap that still counts as touching, a distance. */
        public var tolerance:Number = 0;

        /** The axis that is tried: of Numbers that are passed V8 makes objects. */
        public var axisX:Number = 0;

        /** @copy #axisX */
        public var axisY:Number = 0;

        /** @copy #axisX */
        public var axisZ:Number = 0;

        /** Whether triangles without area are compared as segments: no contact is looked for. */
        protected var comparesSegments:Boolean = true;

        /** The longest edge of the first, with the tolerance as its radius, where the triangles are compared as segments. */
        protected var segmentA:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);

        /** That of the second. */
        protected var segmentB:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);

        /** The first triangle's second corner, from its first. */
        public var ux:Number;

        /** @copy #ux */
        public var uy:Number;

        /** @copy #ux */
        public var uz:Number;

        /** The first triangle's third corner, from its first. */
        public var vx:Number;

        /** @copy #vx */
        public var vy:Number;

        /** @copy #vx */
        public var vz:Number;

        /** The second triangle's first corner, from the first one's first. */
        public var px:Number;

        /** @copy #px */
        public var py:Number;

        /** @copy #px */
        public var pz:Number;

        /** The second triangle's second corner, from the first one's first. */
        public var qx:Number;

        /** @copy #qx */
        public var qy:Number;

        /** @copy #qx */
        public var qz:Number;

        /** The second triangle's third corner, from the first one's first. */
        public var rx:Number;

        /** @copy #rx */
        public var ry:Number;

        /** @copy #rx */
        public var rz:Number;

        // The squared length of an edge; a corner or a normal for the next call.
        private var _longest:Number = 0;
        private var _from:Vector3D = new Vector3D();

        // From the first corner to the second, to the third, and from the second to the third.
        private var _edgesA:Vector.<Number> = new Vector.<Number>(9, true);
        private var _edgesB:Vector.<Number> = new Vector.<Number>(9, true);

        /** No triangles yet. */
        public function TriangleAxes()
        {
        }

        /**
         * Sets the two triangles; the tolerance stays.
         *
         * @param a has nine numbers of a triangle: x, y, z of each corner
         * @param atA where in a they begin
         * @param b has nine numbers of the other
         * @param atB where in b they begin
         */
        public final function relate(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int):void
        {
            var x:Number = a[atA];
            var y:Number = a[int(atA + 1)];
            var z:Number = a[int(atA + 2)];
            ux = a[int(atA + 3)] - x;
            uy = a[int(atA + 4)] - y;
            uz = a[int(atA + 5)] - z;
            vx = a[int(atA + 6)] - x;
            vy = a[int(atA + 7)] - y;
            vz = a[int(atA + 8)] - z;
            px = b[atB] - x;
            py = b[int(atB + 1)] - y;
            pz = b[int(atB + 2)] - z;
            qx = b[int(atB + 3)] - x;
            qy = b[int(atB + 4)] - y;
            qz = b[int(atB + 5)] - z;
            rx = b[int(atB + 6)] - x;
            ry = b[int(atB + 7)] - y;
            rz = b[int(atB + 8)] - z;
        }

        /** Whether the triangles have a gap of more than the tolerance. Those of one surface, or of models in one place, share corners. */
        internal final function areApart():Boolean
        {
            return !areCornersShared() && areSeparated();
        }

        /** Tries the axes until one separates the triangles. */
        protected final function areSeparated():Boolean
        {
            var nx:Number = uy * vz - uz * vy;
            var ny:Number = uz * vx - ux * vz;
            var nz:Number = ux * vy - uy * vx;
            axisX = nx;
            axisY = ny;
            axisZ = nz;
            if (isAxis())
            {
                return true;
            }
            setEdges();
            var edgesA:Vector.<Number> = _edgesA;
            var edgesB:Vector.<Number> = _edgesB;
            var mx:Number = edgesB[1] * edgesB[5] - edgesB[2] * edgesB[4];
            var my:Number = edgesB[2] * edgesB[3] - edgesB[0] * edgesB[5];
            var mz:Number = edgesB[0] * edgesB[4] - edgesB[1] * edgesB[3];
            axisX = mx;
            axisY = my;
            axisZ = mz;
            if (isAxis())
            {
                return true;
            }
            // Squared heights over the longest edges, relative to these: that is how precise the normals are.
            findLongest(edgesA);
            var longestA:Number = _longest;
            findLongest(edgesB);
            var longestB:Number = _longest;
            var areaA:Number = nx * nx + ny * ny + nz * nz;
            var areaB:Number = mx * mx + my * my + mz * mz;
            var isFlatA:Boolean = areaA <= Tolerances.FLAT_TRIANGLE * longestA * longestA;
            var isFlatB:Boolean = areaB <= Tolerances.FLAT_TRIANGLE * longestB * longestB;
            if (isFlatA && isFlatB && comparesSegments)
            {
                _from.x = _from.y = _from.z = 0;
                setLongestEdge(segmentA, edgesA);
                _from.x = px;
                _from.y = py;
                _from.z = pz;
                setLongestEdge(segmentB, edgesB);
                segmentA.radius = tolerance;
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
                    axisX = ey * fz - ez * fy;
                    axisY = ez * fx - ex * fz;
                    axisZ = ex * fy - ey * fx;
                    if (isAxis())
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
            _from.x = nx;
            _from.y = ny;
            _from.z = nz;
            return isAxisInPlane(edgesA) || isAxisInPlane(edgesB);
        }

        /**
         * Tries the axis, of any length, where a contact is looked for: the projections are found.
         */
        protected function tryDepth():void
        {
        }

        /** Whether two triangles without area are separated: segmentA and segmentB. */
        protected function areSegmentsSeparated():Boolean
        {
            return !capsuleCapsule(segmentA, segmentB);
        }

        // Of the plane with the normal that was set.
        private function isAxisInPlane(edges:Vector.<Number>):Boolean
        {
            var nx:Number = _from.x;
            var ny:Number = _from.y;
            var nz:Number = _from.z;
            for (var i:int = 0; i < 9; i += 3)
            {
                var x:Number = edges[i];
                var y:Number = edges[int(i + 1)];
                var z:Number = edges[int(i + 2)];
                axisX = y * nz - z * ny;
                axisY = z * nx - x * nz;
                axisZ = x * ny - y * nx;
                if (isAxis())
                {
                    return true;
                }
            }
            return false;
        }

        /** Whether the axis separates the triangles. */
        internal final function isAxis():Boolean
        {
            var x:Number = axisX;
            var y:Number = axisY;
            var z:Number = axisZ;
            var second:Number = x * ux + y * uy + z * uz;
            var third:Number = x * vx + y * vy + z * vz;
            var low:Number = second < 0 ? second : 0;
            low = third < low ? third : low;
            var high:Number = second > 0 ? second : 0;
            high = third > high ? third : high;
            var first:Number = x * px + y * py + z * pz;
            second = x * qx + y * qy + z * qz;
            third = x * rx + y * ry + z * rz;
            if (isStanding && !(first > high && second > high && third > high) && !(first < low && second < low && third < low))
            {
                return false;
            }
            var lowB:Number = first < second ? first : second;
            lowB = third < lowB ? third : lowB;
            var highB:Number = first > second ? first : second;
            highB = third > highB ? third : highB;
            if (isStanding)
            {
                var gap:Number = lowB > high ? lowB - high : low - highB;
                return gap > 0 && gap * gap > tolerance * tolerance * (x * x + y * y + z * z);
            }
            times.at = (lowB + highB - low - high) / 2;
            times.reach = (high - low + highB - lowB) / 2;
            if (comparesSegments)
            {
                times.speed = x * motion.x + y * motion.y + z * motion.z;
                times.gap = tolerance * Math.sqrt(x * x + y * y + z * z);
                return times.areSeparated();
            }
            tryDepth();
            return false;
        }

        // Whether a corner of the second is where one of the first is.
        private function areCornersShared():Boolean
        {
            var corner:Vector3D = _from;
            corner.x = corner.y = corner.z = 0;
            if (isCornerShared())
            {
                return true;
            }
            corner.x = ux;
            corner.y = uy;
            corner.z = uz;
            if (isCornerShared())
            {
                return true;
            }
            corner.x = vx;
            corner.y = vy;
            corner.z = vz;
            return isCornerShared();
        }

        private function isCornerShared():Boolean
        {
            var x:Number = _from.x;
            var y:Number = _from.y;
            var z:Number = _from.z;
            var limit:Number = tolerance * tolerance;
            var dx:Number = px - x;
            var dy:Number = py - y;
            var dz:Number = pz - z;
            var isShared:Boolean = dx * dx + dy * dy + dz * dz <= limit;
            dx = qx - x;
            dy = qy - y;
            dz = qz - z;
            isShared ||= dx * dx + dy * dy + dz * dz <= limit;
            dx = rx - x;
            dy = ry - y;
            dz = rz - z;
            return isShared || dx * dx + dy * dy + dz * dz <= limit;
        }

        private function setEdges():void
        {
            var edges:Vector.<Number> = _edgesA;
            edges[0] = ux;
            edges[1] = uy;
            edges[2] = uz;
            edges[3] = vx;
            edges[4] = vy;
            edges[5] = vz;
            setThirdEdge(edges);
            edges = _edgesB;
            edges[0] = qx - px;
            edges[1] = qy - py;
            edges[2] = qz - pz;
            edges[3] = rx - px;
            edges[4] = ry - py;
            edges[5] = rz - pz;
            setThirdEdge(edges);
        }

        private static function setThirdEdge(edges:Vector.<Number>):void
        {
            edges[6] = edges[3] - edges[0];
            edges[7] = edges[4] - edges[1];
            edges[8] = edges[5] - edges[2];
        }

        // Finds the squared length of the longest edge.
        private function findLongest(edges:Vector.<Number>):void
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
            _longest = most;
        }

        // From a triangle's first corner on, which is set: the third edge begins where the first ends.
        private function setLongestEdge(segment:Capsule, edges:Vector.<Number>):void
        {
            findLongest(edges);
            var most:Number = _longest;
            var x:Number = _from.x;
            var y:Number = _from.y;
            var z:Number = _from.z;
            var at:int = 0;
            while (at < 6 && edges[at] * edges[at] + edges[int(at + 1)] * edges[int(at + 1)] + edges[int(at + 2)] * edges[int(at + 2)] < most)
            {
                at += 3;
            }
            if (at == 6)
            {
                x += edges[0];
                y += edges[1];
                z += edges[2];
            }
            var end:Vector3D = segment.start;
            end.x = x;
            end.y = y;
            end.z = z;
            end = segment.end;
            end.x = x + edges[at];
            end.y = y + edges[int(at + 1)];
            end.z = z + edges[int(at + 2)];
        }
    }
}
