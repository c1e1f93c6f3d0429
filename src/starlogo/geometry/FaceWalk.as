package starlogo.geometry
{
    import starlogo.steps.Steps;

    /**
     * A walk over a hull that QuickHull has built, from face to neighbour: all of its faces, and which of their vertices are
     * corners of the hull, rather than inside an edge or a flat side. A step takes a millisecond or two.
     */
    internal final class FaceWalk implements Steps
    {
        private static const FACES_A_STEP:int = 700;

        private var _points:Vector.<Number>;
        private var _faces:Vector.<HullFace>;
        private var _areVerticesChecked:Boolean;
        private var _corners:Vector.<int> = null;
        private var _isWalking:Boolean = true;
        private var _next:int = 0;

        // How many edges that are none of a flat side meet at each point; -1 for one that is no vertex.
        private var _edgeEnds:Vector.<int> = null;

        /**
         * @param points x, y, z of every point
         * @param face any of the faces
         * @param areVerticesChecked false if all vertices are known to be corners
         */
        public function FaceWalk(points:Vector.<Number>, face:HullFace, areVerticesChecked:Boolean)
        {
            _points = points;
            _faces = new <HullFace>[face];
            face.isVisited = true;
            _areVerticesChecked = areVerticesChecked;
        }

        /** All faces, when no step is left. */
        public function get faces():Vector.<HullFace>
        {
            return _faces;
        }

        /** The vertices that are corners, as indices of points; null if all are. */
        public function get corners():Vector.<int>
        {
            return _corners;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            if (_isWalking)
            {
                _isWalking = walk();
                return _isWalking || _areVerticesChecked;
            }
            if (_edgeEnds == null)
            {
                _edgeEnds = noEdges();
                _next = 0;
                return true;
            }
            if (countEdges())
            {
                return true;
            }
            _corners = findCorners();
            return false;
        }

        private function walk():Boolean
        {
            var end:int = _next + FACES_A_STEP;
            for (var i:int = _next; i < _faces.length && i < end; i++)
            {
                var face:HullFace = _faces[i];
                visit(face.acrossAB);
                visit(face.acrossBC);
                visit(face.acrossCA);
            }
            _next = i;
            return i < _faces.length;
        }

        private function visit(face:HullFace):void
        {
            if (!face.isVisited)
            {
                face.isVisited = true;
                _faces.push(face);
            }
        }

        // 0 for each point that is a vertex of the faces, -1 for the others.
        private function noEdges():Vector.<int>
        {
            var edgeEnds:Vector.<int> = new Vector.<int>(_points.length / 3);
            var i:int;
            for (i = 0; i < edgeEnds.length; i++)
            {
                edgeEnds[i] = -1;
            }
            for (i = 0; i < _faces.length; i++)
            {
                edgeEnds[_faces[i].a] = edgeEnds[_faces[i].b] = edgeEnds[_faces[i].c] = 0;
            }
            return edgeEnds;
        }

        private function countEdges():Boolean
        {
            var end:int = Math.min(_next + FACES_A_STEP, _faces.length);
            for (var i:int = _next; i < end; i++)
            {
                var face:HullFace = _faces[i];
                countEdge(face, face.acrossAB, face.a, face.b);
                countEdge(face, face.acrossBC, face.b, face.c);
                countEdge(face, face.acrossCA, face.c, face.a);
            }
            _next = end;
            return end < _faces.length;
        }

        // Each edge is met twice, and counted once. It is none of a flat side if the neighbour's third corner is below it.
        private function countEdge(face:HullFace, neighbor:HullFace, from:int, to:int):void
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
            if (face.side(_points, third) != 0)
            {
                _edgeEnds[from]++;
                _edgeEnds[to]++;
            }
        }

        // The vertices where at least three edges that are none of a flat side meet; null when that is all of them.
        private function findCorners():Vector.<int>
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
            return areAll ? null : found;
        }
    }
}
