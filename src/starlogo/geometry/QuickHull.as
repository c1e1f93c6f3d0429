package starlogo.geometry
{
    /**
     * The convex hull of points on a grid of whole numbers, by quickhull (Barber, Dobkin, Huhdanpaa, "The Quickhull
     * Algorithm for Convex Hulls", ACM Transactions on Mathematical Software 22(4), 1996) without its merging of facets.
     *
     * <p>Merging is what makes quickhull over rounded numbers survive coplanar points. Here no decision is ever rounded:
     * coordinates are whole numbers up to 2^25, so a face's normal is exact in a double, and the side of the
     * face on which a point lies is exact in two. Coplanar, collinear and duplicate points therefore need no special case:
     * a point in a face's plane does not see that face.</p>
     *
     * <p>Cost: about n log n for n points; the worst case, which no model comes near, is quadratic. The work can be done in
     * steps: <code>begin()</code>, then <code>step()</code> until nothing is left.</p>
     */
    public final class QuickHull
    {
        /** The largest coordinate of the grid: with it a normal stays below 2^51, and its halves' products below 2^53. */
        public static const GRID:Number = 33554432;

        private static const COPLANAR:Number = Tolerances.HULL_COPLANAR;
        private static const CERTAIN:Number = Tolerances.HULL_CERTAIN;

        // Where a normal's components are split for exact products.
        private static const SPLIT:Number = 67108864;

        // About how much a step does: points put on lists, points looked at per new face, faces walked over; and how many
        // looks making a face takes as long as.
        private static const POINTS_A_STEP:int = 500;
        private static const LOOKS_A_STEP:int = 3000;
        private static const LOOKS_A_FACE:int = 12;
        private static const FACES_A_STEP:int = 700;

        private static const ASSIGNING:int = 0;
        private static const GROWING:int = 1;
        private static const COLLECTING:int = 2;
        private static const COUNTING:int = 3;
        private static const DONE:int = 4;

        private var _points:Vector.<Number>;
        private var _phase:int;

        // The points to build the hull of: those listed, or all where that is null; and the next to be assigned.
        private var _among:Vector.<int>;
        private var _nextPoint:int;
        private var _last:HullFace;
        private var _faces:Vector.<HullFace>;
        private var _nextFace:int;
        private var _edgeEnds:Vector.<int>;
        private var _nextOutside:Vector.<int>;
        private var _faceFrom:Vector.<HullFace>;
        private var _pending:Vector.<HullFace> = new Vector.<HullFace>();
        private var _seen:Vector.<HullFace> = new Vector.<HullFace>();
        private var _horizon:Vector.<HullFace> = new Vector.<HullFace>();
        private var _created:Vector.<HullFace> = new Vector.<HullFace>();

        /**
         * @param points x, y, z of every point: whole numbers from 0 to GRID
         */
        public function QuickHull(points:Vector.<Number>)
        {
            _points = points;
        }

        /**
         * The hull's faces, triangles all, each vertex a corner of it (no vertex inside an edge or a flat side).
         *
         * @param a index of a point; the four span a tetrahedron
         * @param b index of a point
         * @param c index of a point
         * @param d index of a point
         */
        public function build(a:int, b:int, c:int, d:int):Vector.<HullFace>
        {
            begin(a, b, c, d);
            var hasMore:Boolean = true;
            while (hasMore)
            {
                hasMore = step();
            }
            return _faces;
        }

        /**
         * Begins what <code>build()</code> does.
         *
         * @param a index of a point; the four span a tetrahedron
         * @param b index of a point
         * @param c index of a point
         * @param d index of a point
         */
        public function begin(a:int, b:int, c:int, d:int):void
        {
            start(a, b, c, d, null);
        }

        /**
         * Goes on with what was begun: a millisecond or two of it.
         *
         * @return whether there is more to do
         */
        public function step():Boolean
        {
            switch (_phase)
            {
                case ASSIGNING:
                    assignSome();
                    break;
                case GROWING:
                    growSome();
                    break;
                case COLLECTING:
                    collectSome();
                    break;
                case COUNTING:
                    countSome();
                    break;
            }
            return _phase != DONE;
        }

        /** What <code>build()</code> returns, when no step is left. */
        public function get faces():Vector.<HullFace>
        {
            return _faces;
        }

        private function start(a:int, b:int, c:int, d:int, among:Vector.<int>):void
        {
            var count:int = _points.length / 3;
            _nextOutside = new Vector.<int>(count);
            _faceFrom = new Vector.<HullFace>(count);
            _pending.length = 0;
            if (side(new HullFace(_points, a, b, c), d) > 0)
            {
                var swap:int = b;
                b = c;
                c = swap;
            }
            var base:HullFace = new HullFace(_points, a, b, c);
            var sideAB:HullFace = new HullFace(_points, b, a, d);
            var sideBC:HullFace = new HullFace(_points, c, b, d);
            var sideCA:HullFace = new HullFace(_points, a, c, d);
            base.acrossAB = sideAB;
            base.acrossBC = sideBC;
            base.acrossCA = sideCA;
            sideAB.acrossAB = sideBC.acrossAB = sideCA.acrossAB = base;
            sideAB.acrossBC = sideCA;
            sideCA.acrossCA = sideAB;
            sideCA.acrossBC = sideBC;
            sideBC.acrossCA = sideCA;
            sideBC.acrossBC = sideAB;
            sideAB.acrossCA = sideBC;
            _created.length = 0;
            _created.push(base, sideAB, sideBC, sideCA);
            _last = base;
            _among = among;
            _nextPoint = 0;
            _phase = ASSIGNING;
        }

        private function assignSome():void
        {
            var count:int = _among == null ? _points.length / 3 : _among.length;
            var end:int = Math.min(_nextPoint + POINTS_A_STEP, count);
            var i:int;
            if (_among == null)
            {
                for (i = _nextPoint; i < end; i++)
                {
                    assign(i);
                }
            }
            else
            {
                for (i = _nextPoint; i < end; i++)
                {
                    assign(_among[i]);
                }
            }
            _nextPoint = end;
            if (end == count)
            {
                _phase = GROWING;
            }
        }

        private function restart(corners:Vector.<int>):void
        {
            var a:int = corners[0];
            var b:int = corners[1];
            var i:int = 2;
            while (areCollinear(a, b, corners[i]))
            {
                i++;
            }
            var base:HullFace = new HullFace(_points, a, b, corners[i]);
            var j:int = 2;
            while (side(base, corners[j]) == 0)
            {
                j++;
            }
            start(a, b, corners[i], corners[j], corners);
        }

        private function areCollinear(a:int, b:int, c:int):Boolean
        {
            var face:HullFace = new HullFace(_points, a, b, c);
            return face.exactX == 0 && face.exactY == 0 && face.exactZ == 0;
        }

        private function growSome():void
        {
            var looks:int = 0;
            while (_pending.length > 0)
            {
                var face:HullFace = _pending.pop();
                if (face.isBuried || face.farthest < 0)
                {
                    continue;
                }
                var moved:int = addVertex(face.farthest, face);
                _last = _created[0];
                looks += (moved + LOOKS_A_FACE) * _created.length;
                if (looks > LOOKS_A_STEP)
                {
                    return;
                }
            }
            _faces = new <HullFace>[_last];
            _last.isVisited = true;
            _nextFace = 0;
            _phase = COLLECTING;
        }

        // Returns how many points had to be looked at again, the vertex being one of them.
        private function addVertex(eye:int, face:HullFace):int
        {
            findHorizon(eye, face);
            buildCone(eye);
            var moved:int = 0;
            for (var i:int = 0; i < _seen.length; i++)
            {
                var point:int = _seen[i].firstOutside;
                while (point >= 0)
                {
                    var next:int = _nextOutside[point];
                    if (point != eye)
                    {
                        assign(point);
                    }
                    moved++;
                    point = next;
                }
            }
            return moved;
        }

        // Fills _seen with the faces that the eye sees, and _horizon with pairs: a seen face, its unseen neighbour.
        private function findHorizon(eye:int, face:HullFace):void
        {
            _seen.length = 0;
            _horizon.length = 0;
            face.isBuried = true;
            _seen.push(face);
            for (var i:int = 0; i < _seen.length; i++)
            {
                face = _seen[i];
                look(eye, face, face.acrossAB);
                look(eye, face, face.acrossBC);
                look(eye, face, face.acrossCA);
            }
        }

        private function look(eye:int, face:HullFace, neighbor:HullFace):void
        {
            if (neighbor.isBuried)
            {
                return;
            }
            if (side(neighbor, eye) > 0)
            {
                neighbor.isBuried = true;
                _seen.push(neighbor);
            }
            else
            {
                _horizon.push(face, neighbor);
            }
        }

        private function buildCone(eye:int):void
        {
            _created.length = 0;
            var i:int;
            var created:HullFace;
            for (i = 0; i < _horizon.length; i += 2)
            {
                var seen:HullFace = _horizon[i];
                var unseen:HullFace = _horizon[i + 1];
                var from:int = seen.a;
                var to:int = seen.b;
                if (seen.acrossBC == unseen)
                {
                    from = seen.b;
                    to = seen.c;
                }
                else if (seen.acrossCA == unseen)
                {
                    from = seen.c;
                    to = seen.a;
                }
                created = new HullFace(_points, from, to, eye);
                created.acrossAB = unseen;
                unseen.setNeighbor(to, from, created);
                _faceFrom[from] = created;
                _created.push(created);
            }
            for (i = 0; i < _created.length; i++)
            {
                created = _created[i];
                var next:HullFace = _faceFrom[created.b];
                created.acrossBC = next;
                next.acrossCA = created;
            }
        }

        // Puts the point on the list of a new face that it lies beyond; one that lies beyond none is inside for good.
        private function assign(point:int):void
        {
            var x:Number = _points[3 * point];
            var y:Number = _points[3 * point + 1];
            var z:Number = _points[3 * point + 2];
            var count:int = _created.length;
            var nearFace:HullFace = null;
            var near:Number = 0;
            for (var i:int = 0; i < count; i++)
            {
                var face:HullFace = _created[i];
                var distance:Number = face.normalX * x + face.normalY * y + face.normalZ * z - face.offset;
                if (distance > COPLANAR)
                {
                    put(point, face, distance);
                    return;
                }
                if (distance > CERTAIN)
                {
                    if (isAbove(face, x, y, z))
                    {
                        return;
                    }
                    nearFace = face;
                    near = distance;
                }
            }
            if (nearFace != null)
            {
                put(point, nearFace, near);
            }
        }

        private function put(point:int, face:HullFace, distance:Number):void
        {
            if (face.firstOutside < 0)
            {
                _pending.push(face);
            }
            _nextOutside[point] = face.firstOutside;
            face.firstOutside = point;
            if (distance > face.farthestDistance + CERTAIN)
            {
                face.farthestDistance = distance;
                face.farthest = point;
            }
            else if (distance >= face.farthestDistance - CERTAIN && outness(point) > outness(face.farthest))
            {
                // of points on a side parallel to the face, one at its rim
                face.farthest = point;
            }
        }

        // The squared distance from the grid's middle.
        private function outness(point:int):Number
        {
            var x:Number = _points[3 * point] - GRID / 2;
            var y:Number = _points[3 * point + 1] - GRID / 2;
            var z:Number = _points[3 * point + 2] - GRID / 2;
            return x * x + y * y + z * z;
        }

        // Whether the point is over the triangle, not just over its plane.
        private function isAbove(face:HullFace, x:Number, y:Number, z:Number):Boolean
        {
            return isLeftOf(face, face.a, face.b, x, y, z) && isLeftOf(face, face.b, face.c, x, y, z)
                && isLeftOf(face, face.c, face.a, x, y, z);
        }

        private function isLeftOf(face:HullFace, from:int, to:int, x:Number, y:Number, z:Number):Boolean
        {
            var fromX:Number = _points[3 * from];
            var fromY:Number = _points[3 * from + 1];
            var fromZ:Number = _points[3 * from + 2];
            var edgeX:Number = _points[3 * to] - fromX;
            var edgeY:Number = _points[3 * to + 1] - fromY;
            var edgeZ:Number = _points[3 * to + 2] - fromZ;
            x -= fromX;
            y -= fromY;
            z -= fromZ;
            return face.normalX * (edgeY * z - edgeZ * y) + face.normalY * (edgeZ * x - edgeX * z)
                + face.normalZ * (edgeX * y - edgeY * x) >= 0;
        }

        // Positive beyond the face, negative behind it, 0 exactly in its plane.
        private function side(face:HullFace, point:int):Number
        {
            var x:Number = _points[3 * point];
            var y:Number = _points[3 * point + 1];
            var z:Number = _points[3 * point + 2];
            var distance:Number = face.normalX * x + face.normalY * y + face.normalZ * z - face.offset;
            if (distance > CERTAIN || distance < -CERTAIN)
            {
                return distance;
            }
            x -= _points[3 * face.a];
            y -= _points[3 * face.a + 1];
            z -= _points[3 * face.a + 2];
            var highX:Number = Math.floor(face.exactX / SPLIT);
            var highY:Number = Math.floor(face.exactY / SPLIT);
            var highZ:Number = Math.floor(face.exactZ / SPLIT);
            var high:Number = highX * x + highY * y + highZ * z;
            var low:Number = (face.exactX - highX * SPLIT) * x + (face.exactY - highY * SPLIT) * y
                + (face.exactZ - highZ * SPLIT) * z;
            return high * SPLIT + low;
        }

        private function collectSome():void
        {
            var all:Vector.<HullFace> = _faces;
            var end:int = _nextFace + FACES_A_STEP;
            for (var i:int = _nextFace; i < all.length && i < end; i++)
            {
                var face:HullFace = all[i];
                visit(face.acrossAB, all);
                visit(face.acrossBC, all);
                visit(face.acrossCA, all);
            }
            _nextFace = i;
            if (i == all.length)
            {
                // a second hull is of corners only
                _phase = _among == null ? COUNTING : DONE;
                _nextFace = 0;
                _edgeEnds = null;
            }
        }

        private static function visit(face:HullFace, faces:Vector.<HullFace>):void
        {
            if (!face.isVisited)
            {
                face.isVisited = true;
                faces.push(face);
            }
        }

        // At first of all, how many edges that are none of a flat side meet at each vertex.
        private function countSome():void
        {
            var all:Vector.<HullFace> = _faces;
            if (_edgeEnds == null)
            {
                _edgeEnds = noEdges(all);
                return;
            }
            var end:int = Math.min(_nextFace + FACES_A_STEP, all.length);
            for (var i:int = _nextFace; i < end; i++)
            {
                var face:HullFace = all[i];
                countEdge(_edgeEnds, face, face.acrossAB, face.a, face.b);
                countEdge(_edgeEnds, face, face.acrossBC, face.b, face.c);
                countEdge(_edgeEnds, face, face.acrossCA, face.c, face.a);
            }
            _nextFace = end;
            if (end < all.length)
            {
                return;
            }
            _phase = DONE;
            var corners:Vector.<int> = cornersOf(_edgeEnds);
            if (corners != null)
            {
                // Some vertex was taken that later ones have left in the middle of a flat side: again with the others alone.
                restart(corners);
            }
        }

        // 0 for each point that is a vertex of the faces, -1 for the others.
        private function noEdges(all:Vector.<HullFace>):Vector.<int>
        {
            var edgeEnds:Vector.<int> = new Vector.<int>(_points.length / 3);
            var i:int;
            for (i = 0; i < edgeEnds.length; i++)
            {
                edgeEnds[i] = -1;
            }
            for (i = 0; i < all.length; i++)
            {
                edgeEnds[all[i].a] = edgeEnds[all[i].b] = edgeEnds[all[i].c] = 0;
            }
            return edgeEnds;
        }

        // The vertices where at least three edges that are none of a flat side meet; null when that is all of them.
        private static function cornersOf(edgeEnds:Vector.<int>):Vector.<int>
        {
            var corners:Vector.<int> = new Vector.<int>();
            var areAll:Boolean = true;
            for (var i:int = 0; i < edgeEnds.length; i++)
            {
                if (edgeEnds[i] >= 3)
                {
                    corners.push(i);
                }
                else if (edgeEnds[i] >= 0)
                {
                    areAll = false;
                }
            }
            return areAll ? null : corners;
        }

        // Each edge is met twice, and counted once. It is none of a flat side if the neighbour's third corner is below it.
        private function countEdge(edgeEnds:Vector.<int>, face:HullFace, neighbor:HullFace, from:int, to:int):void
        {
            if (from > to)
            {
                return;
            }
            var third:int = neighbor.a;
            if (third == face.a || third == face.b || third == face.c)
            {
                third = neighbor.b;
                if (third == face.a || third == face.b || third == face.c)
                {
                    third = neighbor.c;
                }
            }
            if (side(face, third) != 0)
            {
                edgeEnds[from]++;
                edgeEnds[to]++;
            }
        }
    }
}
