package starlogo.geometry.hull
{
    import starlogo.steps.StepSequence;
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
     *
     * @private
     */
    public final class QuickHull extends StepSequence
    {
        /** The largest coordinate of the grid: with it a normal stays below 2^51, and its halves' products below 2^53. */
        public static const GRID:Number = 33554432;

        // About how much a step does: points put on lists, and points looked at for each new face; and to how many points looked at the making of a
        // face is equal in time.
        private static const POINTS_PER_STEP:int = 500;
        private static const LOOKS_PER_STEP:int = 3000;
        private static const LOOKS_PER_FACE:int = 12;

        private var _points:Vector.<Number>;
        private var _simplex:Vector.<int>;

        // the points to build the hull of: those listed, or all where that is null
        private var _among:Vector.<int>;
        private var _last:HullFace;
        private var _walk:FaceWalk;
        private var _outside:OutsidePoints;
        // By point: of the faces that a new vertex adds, the one whose edge on the horizon begins there.
        private var _faceFrom:Vector.<HullFace>;

        // For the vertex under way: the faces that it sees, pairs of one of these and a neighbour that it does not see, and the new faces.
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
            call(start);
        }

        /**
         * The hull's triangles, three indices of points each, counter-clockwise seen from outside, each vertex a corner of the hull
         * (no vertex inside an edge or a flat side); when no step is left.
         */
        public function get triangles():Vector.<int>
        {
            var faces:Vector.<HullFace> = _walk.faces;
            var count:int = faces.length;
            var corners:Vector.<int> = new Vector.<int>(3 * count);
            for (var i:int = 0; i < count; i++)
            {
                corners[3 * i] = faces[i].a;
                corners[3 * i + 1] = faces[i].b;
                corners[3 * i + 2] = faces[i].c;
            }
            return corners;
        }

        private function start():void
        {
            build(_simplex[0], _simplex[1], _simplex[2], _simplex[3], null);
        }

        // Adds the steps of building the hull of all points, or of those listed, from a tetrahedron of four.
        private function build(a:int, b:int, c:int, d:int, among:Vector.<int>):void
        {
            var count:int = _points.length / 3;
            _outside = new OutsidePoints(_points);
            _faceFrom = new Vector.<HullFace>(count);
            _created = HullFace.tetrahedron(_points, a, b, c, d);
            _last = _created[0];
            _among = among;
            slices(among == null ? count : among.length, POINTS_PER_STEP, assign).repeat(grow).begin(walk).call(restartIfFlat);
        }

        private function assign(first:int, end:int):void
        {
            var among:Vector.<int> = _among;
            for (var i:int = first; i < end; i++)
            {
                var point:int = i;
                if (among != null)
                {
                    point = among[i];
                }
                _outside.assign(point, _created);
            }
        }

        // A vertex may have been taken that is in the middle of a flat side once later vertices are added: then the hull of the others alone is
        // built.
        private function restartIfFlat():void
        {
            if (_walk.corners != null)
            {
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
            build(a, b, corners[i], corners[j], corners);
        }

        private function areCollinear(a:int, b:int, c:int):Boolean
        {
            var face:HullFace = new HullFace(_points, a, b, c);
            return face.exactX == 0 && face.exactY == 0 && face.exactZ == 0;
        }

        private function grow():Boolean
        {
            var looks:int = 0;
            while (looks <= LOOKS_PER_STEP)
            {
                if (_outside.isDealing)
                {
                    var most:int = (LOOKS_PER_STEP - looks) / _created.length + 1;
                    looks += _outside.dealSome(_created, most) * _created.length;
                    continue;
                }
                var face:HullFace = _outside.nextFace();
                if (face == null)
                {
                    return false;
                }
                addVertex(face.farthest, face);
                looks += LOOKS_PER_FACE * _created.length;
            }
            return true;
        }

        private function walk():Steps
        {
            // a second hull is of corners only
            _walk = new FaceWalk(_points, _last, _among == null);
            return _walk;
        }

        private function addVertex(eye:int, face:HullFace):void
        {
            findHorizon(eye, face);
            buildCone(eye);
            _outside.deal(_seen, eye);
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
