package starlogo.geometry.hull
{
    import starlogo.steps.StepSequence;

    /**
     * A walk over a hull that QuickHull has built, from face to neighbour: all of its faces, and which of their vertices are
     * corners of the hull, rather than inside an edge or a flat side. A step takes a millisecond or two.
     */
    internal final class FaceWalk extends StepSequence
    {
        private static const FACES_PER_STEP:int = 700;

        /** All faces, when no step is left. */
        public var faces:Vector.<HullFace>;

        /** The vertices that are corners, as indices of points; null if all are. */
        public var corners:Vector.<int> = null;

        private var _points:Vector.<Number>;
        private var _next:int = 0;

        // how many edges meet at each point, those inside of a flat side not counted; -1 for a point that is no vertex
        private var _edgeEnds:Vector.<int>;

        /**
         * @param points x, y, z of every point
         * @param face any of the faces
         * @param areVerticesChecked false if all vertices are known to be corners
         */
        public function FaceWalk(points:Vector.<Number>, face:HullFace, areVerticesChecked:Boolean)
        {
            _points = points;
            faces = new <HullFace>[face];
            face.isVisited = true;
            repeat(walk);
            if (areVerticesChecked)
            {
                call(clearEdges);
            }
        }

        private function walk():Boolean
        {
            var end:int = _next + FACES_PER_STEP;
            for (var i:int = _next; i < faces.length && i < end; i++)
            {
                var face:HullFace = faces[i];
                visit(face.acrossAB);
                visit(face.acrossBC);
                visit(face.acrossCA);
            }
            _next = i;
            return i < faces.length;
        }

        private function visit(face:HullFace):void
        {
            if (!face.isVisited)
            {
                face.isVisited = true;
                faces.push(face);
            }
        }

        // 0 for each point that is a vertex of the faces, -1 for the others.
        private function clearEdges():void
        {
            var edgeEnds:Vector.<int> = new Vector.<int>(_points.length / 3);
            var i:int;
            for (i = 0; i < edgeEnds.length; i++)
            {
                edgeEnds[i] = -1;
            }
            for (i = 0; i < faces.length; i++)
            {
                edgeEnds[faces[i].a] = edgeEnds[faces[i].b] = edgeEnds[faces[i].c] = 0;
            }
            _edgeEnds = edgeEnds;
            slices(faces.length, FACES_PER_STEP, countEdges).call(findCorners);
        }

        private function countEdges(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var face:HullFace = faces[i];
                countEdge(face, face.acrossAB, face.a, face.b);
                countEdge(face, face.acrossBC, face.b, face.c);
                countEdge(face, face.acrossCA, face.c, face.a);
            }
        }

        // Each edge is met twice, and counted once. It is not inside of a flat side if the neighbour's third corner is below the face.
        private function countEdge(face:HullFace, neighbor:HullFace, from:int, to:int):void
        {
            if (from > to)
            {
                return;
            }
            var third:int = neighbor.a;
            if (third == from || third == to)
            {
                third = neighbor.b;
                if (third == from || third == to)
                {
                    third = neighbor.c;
                }
            }
            if (face.side(_points, third) != 0)
            {
                _edgeEnds[from]++;
                _edgeEnds[to]++;
            }
        }

        // The vertices at which at least three edges meet that are not inside of a flat side; null if that holds for all.
        private function findCorners():void
        {
            var found:Vector.<int> = new Vector.<int>();
            var areAll:Boolean = true;
            for (var i:int = 0; i < _edgeEnds.length; i++)
            {
                if (_edgeEnds[i] >= 3)
                {
                    found.push(i);
                }
                else if (_edgeEnds[i] >= 0)
                {
                    areAll = false;
                }
            }
            corners = areAll ? null : found;
        }
    }
}
