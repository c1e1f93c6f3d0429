package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;

    /**
     * Finds the shortest displacement that separates two cores that touch or overlap (the minimum translation vector, MTV), by the separating axis test
     * (SAT). Its direction is the normal of a face of one, or perpendicular to an edge of each. Of the pairs of edges, only those count whose common
     * perpendicular points out of both (Gregorius, "The separating axis test between convex polyhedra", 2013). The edges of boxes, triangles and
     * segments say nothing of faces, so nothing is known to be on a side of them.
     *
     * <p>If two displacements are equally short, the result is the one that is tried first: faces of the second core, faces of the first, edges. Of two
     * opposite ones, it is the one against the pair's motion. If the pair has no motion, rounding decides. Of two points or parallel
     * segments the first moves upwards as far as possible. A segment beside which the other one has hardly any length counts alone.</p>
     *
     * <p>The results are a unit vector, and how far the cores are apart along it. It is less than 0 if they overlap: the displacement is as long. If they
     * are apart, it is at most their distance, and may be less than 0 if the axis between is across edges that count as parallel.</p>
     */
    internal final class SatPenetration
    {
        // How many numbers describe an edge. 0 to 2: its vector. 3 to 5 and 6 to 8: a normal of each of its two faces, as long as this vector times
        // the height of the face's other point over it; 0 for bare edges.
        private static const PER_EDGE:int = 9;

        // A product whose square is smaller has lost digits. The edges of a structure as long as contacts need have products far above it.
        private static const SMALL:Number = 1e-290;

        // An edge of the first core, and all edges of the second.
        private var _edge:Vector.<Number> = new Vector.<Number>(PER_EDGE, true);
        private var _edges:Vector.<Number> = new Vector.<Number>();

        // An axis to try, of any length. How far the cores' Minkowski difference (see GjkDistance) extends along it, and how far the second core does.
        private var _axis:Vector3D = new Vector3D();
        private var _difference:Interval = new Interval();
        private var _ofSecond:Interval = new Interval();

        /** Finds the displacement of the first core: along the axis, as long as the cores overlap along it. */
        public function findMinimumTranslation(cores:CorePair, out:SeparatingAxis):void
        {
            out.separation = -Infinity;
            considerNormals(cores, out);
            if (out.separation == -Infinity)
            {
                considerUpwards(cores, out);
            }
        }

        /** Takes a normal of a face, or of an edge of each, if the cores are farther apart along it than along the axis before. */
        public function considerNormals(cores:CorePair, out:SeparatingAxis):void
        {
            considerFaces(cores.second, cores, out);
            considerFaces(cores.first, cores, out);
            if (cores.first.edges.length > 0 && cores.second.edges.length > 0)
            {
                considerEdges(cores, out);
            }
        }

        /**
         * Takes the axis along the gap between the cores, if the displacement is shorter along it. Needles have no face whose normal is precise.
         *
         * @param gap between the cores
         * @param out has the displacement that findMinimumTranslation() has found
         */
        public function considerGap(gap:CoreGap, cores:CorePair, out:SeparatingAxis):void
        {
            _axis.setTo(gap.x, gap.y, gap.z);
            considerAxis(_axis, cores, out);
        }

        private function considerFaces(shape:ConvexShape, cores:CorePair, out:SeparatingAxis):void
        {
            var p:Vector.<Number> = shape.points;
            var faces:Vector.<int> = shape.faces;
            for (var f:int = 0; f < faces.length; f += 3)
            {
                var i:int = faces[f];
                var j:int = faces[int(f + 1)];
                var k:int = faces[int(f + 2)];
                var ux:Number = p[j] - p[i];
                var uy:Number = p[int(j + 1)] - p[int(i + 1)];
                var uz:Number = p[int(j + 2)] - p[int(i + 2)];
                var vx:Number = p[k] - p[i];
                var vy:Number = p[int(k + 1)] - p[int(i + 1)];
                var vz:Number = p[int(k + 2)] - p[int(i + 2)];
                findAcross(ux, uy, uz, vx, vy, vz, _axis);
                considerAxis(_axis, cores, out);
            }
        }

        // Finds the axis across two vectors. It is 0 if they are parallel: then a face has no area, and two edges have no common perpendicular.
        private static function findAcross(ux:Number, uy:Number, uz:Number, vx:Number, vy:Number, vz:Number, out:Vector3D):void
        {
            var x:Number = uy * vz - uz * vy;
            var y:Number = uz * vx - ux * vz;
            var z:Number = ux * vy - uy * vx;
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var vv:Number = vx * vx + vy * vy + vz * vz;
            var squared:Number = x * x + y * y + z * z;
            if (!(squared > Tolerances.DIRECTION * Tolerances.DIRECTION * uu * vv + SMALL))
            {
                out.setTo(0, 0, 0);
                return;
            }
            // If the two are nearly parallel, rounding has tilted the axis. It becomes perpendicular to the one again, and so to the other.
            var along:Number = squared < Tolerances.NEARLY_PARALLEL * uu * vv ? (x * ux + y * uy + z * uz) / uu : 0;
            out.setTo(x - along * ux, y - along * uy, z - along * uz);
        }

        private function considerEdges(cores:CorePair, out:SeparatingAxis):void
        {
            var first:ConvexShape = cores.first;
            var areBare:Boolean = !first.hasFacesAtEdges && !cores.second.hasFacesAtEdges;
            var end:int = readEdges(cores.second);
            for (var i:int = 0; i < first.edges.length; i += 4)
            {
                readEdge(first, i, _edge, 0);
                for (var k:int = 0; k < end; k += PER_EDGE)
                {
                    if (areBare || isMinkowskiFace(k))
                    {
                        findAcross(_edge[0], _edge[1], _edge[2], _edges[k], _edges[int(k + 1)], _edges[int(k + 2)], _axis);
                        considerAxis(_axis, cores, out);
                    }
                }
            }
        }

        // Whether an edge u of the first core and an edge v of the second make a face of the Minkowski difference: their perpendicular points out of both
        // cores. That is so if both faces at u are on one side of v, both at v on one side of u, and these two sides are the same.
        private function isMinkowskiFace(k:int):Boolean
        {
            var u:Vector.<Number> = _edge;
            var v:Vector.<Number> = _edges;
            var x:Number = v[k];
            var y:Number = v[int(k + 1)];
            var z:Number = v[int(k + 2)];
            var leftAtU:Number = x * u[3] + y * u[4] + z * u[5];
            var rightAtU:Number = x * u[6] + y * u[7] + z * u[8];
            if (leftAtU * rightAtU < 0)
            {
                return false;
            }
            x = u[0];
            y = u[1];
            z = u[2];
            var leftAtV:Number = x * v[int(k + 3)] + y * v[int(k + 4)] + z * v[int(k + 5)];
            var rightAtV:Number = x * v[int(k + 6)] + y * v[int(k + 7)] + z * v[int(k + 8)];
            return leftAtV * rightAtV >= 0 && (leftAtU + rightAtU) * (leftAtV + rightAtV) >= 0;
        }

        // Reads all edges of the second core. Returns how many numbers they are.
        private function readEdges(second:ConvexShape):int
        {
            var count:int = second.edges.length >> 2;
            // V8 takes longer if the writes below make the list longer
            while (_edges.length < PER_EDGE * count)
            {
                _edges.push(0);
            }
            for (var i:int = 0; i < count; i++)
            {
                readEdge(second, 4 * i, _edges, PER_EDGE * i);
            }
            return PER_EDGE * count;
        }

        // Reads an edge, whose indices in the shape's list begin at one place, and writes its numbers from an index on.
        private static function readEdge(shape:ConvexShape, edge:int, out:Vector.<Number>, to:int):void
        {
            var p:Vector.<Number> = shape.points;
            var edges:Vector.<int> = shape.edges;
            var from:int = edges[edge];
            var end:int = edges[int(edge + 1)];
            var x:Number = p[end] - p[from];
            var y:Number = p[int(end + 1)] - p[int(from + 1)];
            var z:Number = p[int(end + 2)] - p[int(from + 2)];
            out[to] = x;
            out[int(to + 1)] = y;
            out[int(to + 2)] = z;
            for (var i:int = 2; i < 4; i++)
            {
                var across:int = edges[int(edge + i)];
                var toX:Number = p[across] - p[from];
                var toY:Number = p[int(across + 1)] - p[int(from + 1)];
                var toZ:Number = p[int(across + 2)] - p[int(from + 2)];
                to += 3;
                out[to] = toY * z - toZ * y;
                out[int(to + 1)] = toZ * x - toX * z;
                out[int(to + 2)] = toX * y - toY * x;
            }
        }

        // Tries the axis across two points or parallel segments that points upwards as far as possible, for the first core.
        private function considerUpwards(cores:CorePair, out:SeparatingAxis):void
        {
            var axis:Vector3D = _axis;
            axis.setTo(0, 0, 0);
            takeLonger(cores.first, axis);
            takeLonger(cores.second, axis);
            turnUpwards(axis);
            projectDifference(axis, cores, _difference);
            // rounding hides on which side they are
            var isDown:Boolean = _difference.max < -_difference.min - Tolerances.ROUNDING * (cores.first.boundingRadius + cores.second.boundingRadius);
            var sign:int = isDown ? -1 : 1;
            out.setTo(sign * axis.x, sign * axis.y, sign * axis.z, isDown ? -_difference.max : _difference.min);
        }

        // Replaces an axis by a unit vector perpendicular to it that points upwards as far as possible. If the axis is vertical, up to
        // Tolerances.UPRIGHT, the vector is along x. If it is 0, the vector is along z.
        private static function turnUpwards(axis:Vector3D):void
        {
            var x:Number = axis.x;
            var y:Number = axis.y;
            var z:Number = axis.z;
            var squared:Number = x * x + y * y + z * z;
            if (!(squared > 0))
            {
                axis.setTo(0, 0, 1);
                return;
            }
            if (x * x + y * y > Tolerances.UPRIGHT * squared)
            {
                axis.setTo(-x * z / squared, -y * z / squared, 1 - z * z / squared);
            }
            else
            {
                axis.setTo(1 - x * x / squared, -x * y / squared, -x * z / squared);
            }
            var length:Number = Math.sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
            axis.x /= length;
            axis.y /= length;
            axis.z /= length;
        }

        // Takes the vector from the first point of a core to the farthest other one, if it is longer.
        private static function takeLonger(core:ConvexShape, vector:Vector3D):void
        {
            var p:Vector.<Number> = core.points;
            var end:int = ContactFeature.farthestFrom(0, p, core.pointsEnd);
            var x:Number = p[end] - p[0];
            var y:Number = p[int(end + 1)] - p[1];
            var z:Number = p[int(end + 2)] - p[2];
            if (x * x + y * y + z * z > vector.lengthSquared)
            {
                vector.setTo(x, y, z);
            }
        }

        // Takes an axis of any length, or its opposite, if the cores are farther apart along it than along the axis before. An axis of length 0 is none.
        private function considerAxis(axis:Vector3D, cores:CorePair, out:SeparatingAxis):void
        {
            var squared:Number = axis.x * axis.x + axis.y * axis.y + axis.z * axis.z;
            if (!(squared > 0))
            {
                return;
            }
            projectDifference(axis, cores, _difference);
            // how far the cores are apart along the axis and along its opposite, times the axis's length
            var along:Number = _difference.min;
            var against:Number = -_difference.max;
            var greater:Number = against > along ? against : along;
            if (greater < 0 && greater * greater >= out.separation * out.separation * squared)
            {
                return;
            }
            var length:Number = Math.sqrt(squared);
            along /= length;
            against /= length;
            var rounding:Number = Tolerances.ROUNDING * (cores.first.boundingRadius + cores.second.boundingRadius);
            var isOpposite:Boolean = against > along;
            if (against - along <= rounding && along - against <= rounding)
            {
                // rounding hides on which side they are, but not where the first one comes from
                var speed:Number = axis.x * cores.motionX + axis.y * cores.motionY + axis.z * cores.motionZ;
                isOpposite = speed == 0 ? isOpposite : speed > 0;
            }
            var separation:Number = isOpposite ? against : along;
            if (separation > out.separation + rounding)
            {
                length = isOpposite ? -length : length;
                out.setTo(axis.x / length, axis.y / length, axis.z / length, separation);
            }
        }

        // Finds how far the Minkowski difference extends along an axis. The cores are apart if 0 is not between.
        private function projectDifference(axis:Vector3D, cores:CorePair, out:Interval):void
        {
            cores.first.project(axis, out);
            cores.second.project(axis, _ofSecond);
            var from:Number = axis.x * cores.x + axis.y * cores.y + axis.z * cores.z;
            out.min = out.min - _ofSecond.max + from;
            out.max = out.max - _ofSecond.min + from;
        }
    }
}
