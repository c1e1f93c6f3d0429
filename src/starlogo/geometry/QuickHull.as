package starlogo.geometry
{
    import starlogo.steps.Steps;

    /**
     * The convex hull of points on a grid of whole numbers, by quickhull (Barber, Dobkin, Huhdanpaa, "The Quickhull
     * Algorithm for Convex Hulls", ACM Transactions on Mathematical Software 22(4), 1996) without its merging of facets.
     *
     * <p>Merging is what makes quickhull over rounded numbers survive coplanar points. Here no decision is ever rounded:
     * coordinates are whole numbers up to 2^25, so a face's normal is exact in a double, and the side of the
     * face on which a point lies is exact in two. Coplanar, collinear and duplicate points therefore need no special case:
     * a point in a face's plane does not see that face.</p>
     *
     * <p>Cost: about n log n for n points; the worst case, which no model comes near, is quadratic. A step takes a
     * millisecond or two.</p>
     */
    internal final class QuickHull implements Steps
    {
        /** The largest coordinate of the grid: with it a normal stays below 2^51, and its halves' products below 2^53. */
        public static const GRID:Number = 33554432;

        // About how much a step does: points put on lists, points looked at per new face; and how many looks making a face
        // takes as long as.
        private static const POINTS_A_STEP:int = 500;
        private static const LOOKS_A_STEP:int = 3000;
        private static const LOOKS_A_FACE:int = 12;

        private static const STARTING:int = 0;
        private static const ASSIGNING:int = 1;
        private static const GROWING:int = 2;
        private static const WALKING:int = 3;
        private static const DONE:int = 4;

        private var _points:Vector.<Number>;
        private var _simplex:Vector.<int>;
        private var _phase:int = STARTING;

        // The points to build the hull of: those listed, or all where that is null; and the next to be assigned.
        private var _among:Vector.<int>;
        private var _nextPoint:int;
        private var _last:HullFace;
        private var _walk:FaceWalk;
        private var _outside:OutsidePoints;
        private var _faceFrom:Vector.<HullFace>;
        private var _seen:Vector.<HullFace> = new Vector.<HullFace>();
        private var _horizon:Vector.<HullFace> = new Vector.<HullFace>();
        private var _created:Vector.<HullFace> = new Vector.<HullFace>();

        /**
         * @param points x, y, z of every point: whole numbers from 0 to GRID
         * @param simplex indices of four points that span a tetrahedron
         */
        public function QuickHull(points:Vector.<Number>, simplex:Vector.<int>)
        {
            _points = points;
            _simplex = simplex;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            switch (_phase)
            {
                case STARTING:
                    start(_simplex[0], _simplex[1], _simplex[2], _simplex[3], null);
                    break;
                case ASSIGNING:
                    assignSome();
                    break;
                case GROWING:
                    growSome();
                    break;
                case WALKING:
                    if (!_walk.step())
                    {
                        finishOrRestart();
                    }
                    break;
            }
            return _phase != DONE;
        }

        /**
         * The hull's faces, triangles all, each vertex a corner of it (no vertex inside an edge or a flat side); when no step is
         * left.
         */
        public function get faces():Vector.<HullFace>
        {
            return _walk.faces;
        }

        private function start(a:int, b:int, c:int, d:int, among:Vector.<int>):void
        {
            var count:int = _points.length / 3;
            _outside = new OutsidePoints(_points);
            _faceFrom = new Vector.<HullFace>(count);
            _created = HullFace.tetrahedron(_points, a, b, c, d);
            _last = _created[0];
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
                    _outside.assign(i, _created);
                }
            }
            else
            {
                for (i = _nextPoint; i < end; i++)
                {
                    _outside.assign(_among[i], _created);
                }
            }
            _nextPoint = end;
            if (end == count)
            {
                _phase = GROWING;
            }
        }

        private function finishOrRestart():void
        {
            _phase = DONE;
            if (_walk.corners != null)
            {
                // Some vertex was taken that later ones have left in the middle of a flat side: again with the others alone.
                restart(_walk.corners);
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
            while (base.side(_points, corners[j]) == 0)
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
            while (looks <= LOOKS_A_STEP)
            {
                if (_outside.isDealing)
                {
                    var most:int = (LOOKS_A_STEP - looks) / _created.length + 1;
                    looks += _outside.dealSome(_created, most) * _created.length;
                    continue;
                }
                var face:HullFace = _outside.takeFace();
                if (face == null)
                {
                    // a second hull is of corners only
                    _walk = new FaceWalk(_points, _last, _among == null);
                    _phase = WALKING;
                    return;
                }
                addVertex(face.farthest, face);
                looks += LOOKS_A_FACE * _created.length;
            }
        }

        private function addVertex(eye:int, face:HullFace):void
        {
            findHorizon(eye, face);
            buildCone(eye);
            _outside.beginDealing(_seen, eye);
            _last = _created[0];
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
            if (neighbor.side(_points, eye) > 0)
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
    }
}
