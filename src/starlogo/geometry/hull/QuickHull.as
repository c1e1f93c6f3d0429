package starlogo.geometry.hull
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Finds the convex hull of points on a grid of whole numbers, by quickhull (Barber, Dobkin, Huhdanpaa, "The Quickhull Algorithm for
     * Convex Hulls", ACM Transactions on Mathematical Software 22(4), 1996) without its merging of facets.
     *
     * <p>Quickhull over rounded numbers needs merging, because coplanar points break it otherwise. Here the faces that a new vertex sees are
     * found without rounding: coordinates are whole numbers up to 2^25, so a face's normal is exact in one double, and a point's side of the
     * face is exact in two. So coplanar, collinear and duplicate points need no special case: a point in a face's plane does not see that
     * face. Which points become vertices is rounded: OutsidePoints leaves out a point that is at most
     * Tolerances.HULL_COPLANAR above a face and beside it. So the hull is convex, and a point may be outside of it by about that much.</p>
     *
     * <p>The cost is about n log n for n points, for curves and rings too: OutsidePoints chooses the next vertex so that few faces see it. A
     * step takes one or two milliseconds for thousands of points. A new vertex may take a pass over them all.</p>
     *
     * @private
     */
    public final class QuickHull extends StepSequence
    {
        /** The largest coordinate of the grid. With it, a normal stays below 2^51, and the products of its halves stay below 2^53. */
        public static const GRID:Number = 33554432;

        // The approximate work of a step: points put on lists, and tests of a point against a new face. Making a face counts as
        // TESTS_PER_FACE tests.
        private static const POINTS_PER_STEP:int = 500;
        private static const TESTS_PER_STEP:int = 3000;
        private static const TESTS_PER_FACE:int = 12;
        private static const FACES_PER_STEP:int = 500;

        private var _points:Vector.<Number>;
        private var _outside:OutsidePoints;
        // For each point on the horizon, the new face whose edge on the horizon begins at the point.
        private var _faceFrom:Vector.<HullFace>;

        // For the current vertex, the faces that it sees and the new faces.
        private var _seen:Vector.<HullFace> = new Vector.<HullFace>();
        private var _created:Vector.<HullFace> = new Vector.<HullFace>();

        // all faces, after the hull is built
        private var _faces:Vector.<HullFace>;

        /**
         * @param points x, y, z of every point: whole numbers from 0 to GRID
         * @param simplex indices of four points that span a tetrahedron
         */
        public function QuickHull(points:Vector.<Number>, simplex:Vector.<int>)
        {
            _points = points;
            build(simplex[0], simplex[1], simplex[2], simplex[3], null);
        }

        /**
         * The hull's triangles, three indices of points each, counter-clockwise seen from outside. Each vertex is a corner of the hull, and
         * not inside of an edge or a flat side. Complete after the last step.
         */
        public function get triangles():Vector.<int>
        {
            var corners:Vector.<int> = new Vector.<int>();
            for each (var face:HullFace in _faces)
            {
                corners.push(face.a, face.b, face.c);
            }
            return corners;
        }

        // Adds the steps that build the hull of all points, or of the listed points only. It begins as a tetrahedron of four points.
        private function build(a:int, b:int, c:int, d:int, among:Vector.<int>):void
        {
            var count:int = _points.length / 3;
            _outside = new OutsidePoints(_points);
            _faceFrom = new Vector.<HullFace>(count);
            // A triangle with two sides. One of them sees the fourth corner.
            var front:HullFace = new HullFace(_points, a, b, c);
            var back:HullFace = new HullFace(_points, a, c, b);
            front.acrossAB = front.acrossBC = front.acrossCA = back;
            back.acrossAB = back.acrossBC = back.acrossCA = front;
            // The tetrahedron: three new faces and the side that d does not see.
            var seesFront:Boolean = front.side(_points, d) > 0;
            replaceSeenFaces(d, seesFront ? front : back);
            _created.push(seesFront ? back : front);
            // The order decides which face takes a point that is beyond several, and so which points HULL_COPLANAR leaves out.
            _created.reverse();
            slices(among == null ? count : among.length, POINTS_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        _outside.assign(among == null ? i : among[i], _created);
                    }
                }).call(function():void
                {
                    _outside.addPending(_created);
                }).repeat(grow).begin(listingFaces);
        }

        private function grow():Boolean
        {
            var testCount:int = 0;
            while (testCount <= TESTS_PER_STEP)
            {
                var face:HullFace = _outside.nextFace();
                if (face == null)
                {
                    return false;
                }
                replaceSeenFaces(face.farthest, face);
                testCount += (TESTS_PER_FACE + _outside.redistribute(_seen, _created)) * _created.length;
            }
            return true;
        }

        // Makes a point a vertex. Fills _seen with the faces that it sees, one of which is given, and _created with a face from it to each edge around them.
        private function replaceSeenFaces(eye:int, face:HullFace):void
        {
            _created.length = 0;
            _seen.length = 0;
            bury(face);
            for (var i:int = 0; i < _seen.length; i++)
            {
                face = _seen[i];
                visit(eye, face.acrossAB, face.a, face.b);
                visit(eye, face.acrossBC, face.b, face.c);
                visit(eye, face.acrossCA, face.c, face.a);
            }
            for each (var created:HullFace in _created)
            {
                var next:HullFace = _faceFrom[created.b];
                created.acrossBC = next;
                next.acrossCA = created;
            }
        }

        // Visits the neighbour across an edge of a face that the eye sees. If the eye does not see the neighbour, the edge gets a new face.
        private function visit(eye:int, neighbor:HullFace, from:int, to:int):void
        {
            if (neighbor.state == HullFace.BURIED)
            {
                return;
            }
            if (neighbor.side(_points, eye) > 0)
            {
                bury(neighbor);
                return;
            }
            var created:HullFace = new HullFace(_points, from, to, eye);
            created.acrossAB = neighbor;
            neighbor.setNeighbor(to, from, created);
            _faceFrom[from] = created;
            _created.push(created);
        }

        private function bury(face:HullFace):void
        {
            face.state = HullFace.BURIED;
            _seen.push(face);
        }

        // The walk over the hull that is built. It lists the faces, and counts how many edges meet at each point. Edges inside of a flat side are
        // not counted.
        private function listingFaces():Steps
        {
            var edgeCounts:Vector.<int> = new Vector.<int>(_points.length / 3);
            var next:int = 0;
            _faces = new <HullFace>[_created[0]];
            _created[0].state = HullFace.LISTED;
            return new StepSequence().repeat(function():Boolean
                {
                    next = walkFrom(next, edgeCounts);
                    return next < _faces.length;
                }).call(function():void
                {
                    restartIfFlat(edgeCounts);
                });
        }

        // Walks from some faces to their neighbours. Returns the index of the next face.
        private function walkFrom(first:int, edgeCounts:Vector.<int>):int
        {
            var i:int = first;
            for (var end:int = first + FACES_PER_STEP; i < _faces.length && i < end; i++)
            {
                var face:HullFace = _faces[i];
                crossEdge(face, face.acrossAB, face.a, face.b, edgeCounts);
                crossEdge(face, face.acrossBC, face.b, face.c, edgeCounts);
                crossEdge(face, face.acrossCA, face.c, face.a, edgeCounts);
            }
            return i;
        }

        // Counts an edge, and visits the neighbour. An edge is not inside of a flat side if the neighbour's third corner is below the face.
        private function crossEdge(face:HullFace, neighbor:HullFace, from:int, to:int, edgeCounts:Vector.<int>):void
        {
            if (face.side(_points, neighbor.a + neighbor.b + neighbor.c - from - to) != 0)
            {
                edgeCounts[from]++;
            }
            if (neighbor.state != HullFace.LISTED)
            {
                neighbor.state = HullFace.LISTED;
                _faces.push(neighbor);
            }
        }

        // Later vertices may put an earlier one inside of an edge or a flat side. Then fewer than three edges meet at it, and the hull of
        // the other vertices alone is built. A closed surface of triangles has two more vertices than half the number of triangles.
        private function restartIfFlat(edgeCounts:Vector.<int>):void
        {
            var corners:Vector.<int> = new Vector.<int>();
            for (var i:int = 0; i < edgeCounts.length; i++)
            {
                if (edgeCounts[i] > 2)
                {
                    corners.push(i);
                }
            }
            if (corners.length < _faces.length / 2 + 2)
            {
                var base:HullFace = new HullFace(_points, corners[0], corners[1], corners[2]);
                var apex:int = 3;
                while (base.side(_points, corners[apex]) == 0)
                {
                    apex++;
                }
                build(corners[0], corners[1], corners[2], corners[apex], corners);
            }
        }
    }
}
