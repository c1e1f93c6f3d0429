package starlogo.geometry
{
    import starlogo.steps.Steps;

    /**
     * How the corners of a hull are joined: made of QuickHull's faces, in steps, or of a loop of corners at once.
     */
    internal final class HullMesh implements Steps
    {
        private static const NUMBERING:int = 0;
        private static const MESHING:int = 1;
        private static const COUNTING:int = 2;
        private static const FILLING:int = 3;

        private var _vertices:Vector.<Number>;
        private var _faces:Vector.<HullFace>;
        private var _phase:int = NUMBERING;
        private var _indices:Vector.<int>;
        private var _points:Vector.<Number>;
        private var _triangles:Vector.<int> = new Vector.<int>();
        private var _firstNeighbor:Vector.<int>;
        private var _neighbors:Vector.<int>;

        // Where each vertex is among the corners; and each corner beside a neighbour of it, in pairs.
        private var _place:Vector.<int>;
        private var _pairs:Vector.<int>;

        /**
         * @param vertices x, y, z each
         * @param faces of a hull; null to <code>join()</code> corners instead
         */
        public function HullMesh(vertices:Vector.<Number>, faces:Vector.<HullFace> = null)
        {
            _vertices = vertices;
            _faces = faces;
        }

        /** See ConvexHull, here as below. */
        public function get indices():Vector.<int>
        {
            return _indices;
        }

        /** @copy #indices */
        public function get points():Vector.<Number>
        {
            return _points;
        }

        /** @copy #indices */
        public function get triangles():Vector.<int>
        {
            return _triangles;
        }

        /** @copy #indices */
        public function get firstNeighbor():Vector.<int>
        {
            return _firstNeighbor;
        }

        /** @copy #indices */
        public function get neighbors():Vector.<int>
        {
            return _neighbors;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            switch (_phase)
            {
                case NUMBERING:
                    numberCorners();
                    break;
                case MESHING:
                    makeTriangles();
                    break;
                case COUNTING:
                    countNeighbors();
                    break;
                case FILLING:
                    fillNeighbors();
                    break;
            }
            _phase++;
            return _phase <= FILLING;
        }

        /**
         * Joins corners one after the other, the last to the first: a hull without triangles.
         *
         * @param loop the corners, as positions among the vertices
         */
        public function join(loop:Vector.<int>):void
        {
            var count:int = loop.length;
            var sorted:Vector.<int> = loop.concat().sort(Array.NUMERIC);
            number(sorted);
            var place:Vector.<int> = new Vector.<int>(count);
            var i:int;
            for (i = 0; i < count; i++)
            {
                place[i] = sorted.indexOf(loop[i]);
            }
            var pairs:Vector.<int> = new Vector.<int>();
            for (i = 0; i < count && count > 1; i++)
            {
                var next:int = (i + 1) % count;
                pairs.push(place[i], place[next]);
                if (count > 2)
                {
                    pairs.push(place[next], place[i]);
                }
            }
            _pairs = pairs;
            countNeighbors();
            fillNeighbors();
        }

        private function numberCorners():void
        {
            var faces:Vector.<HullFace> = _faces;
            var vertexCount:int = _vertices.length / 3;
            var place:Vector.<int> = new Vector.<int>(vertexCount);
            var count:int = faces.length;
            var i:int;
            for (i = 0; i < count; i++)
            {
                place[faces[i].a] = place[faces[i].b] = place[faces[i].c] = 1;
            }
            var corners:Vector.<int> = new Vector.<int>();
            for (i = 0; i < vertexCount; i++)
            {
                if (place[i] == 1)
                {
                    place[i] = corners.length;
                    corners.push(i);
                }
            }
            number(corners);
            _place = place;
        }

        private function makeTriangles():void
        {
            var faces:Vector.<HullFace> = _faces;
            var place:Vector.<int> = _place;
            var count:int = faces.length;
            var pairs:Vector.<int> = new Vector.<int>(6 * count);
            _triangles.length = 3 * count;
            for (var i:int = 0; i < count; i++)
            {
                var a:int = place[faces[i].a];
                var b:int = place[faces[i].b];
                var c:int = place[faces[i].c];
                var at:int = 3 * i;
                _triangles[at] = pairs[2 * at] = pairs[2 * at + 5] = a;
                _triangles[at + 1] = pairs[2 * at + 1] = pairs[2 * at + 2] = b;
                _triangles[at + 2] = pairs[2 * at + 3] = pairs[2 * at + 4] = c;
            }
            _pairs = pairs;
        }

        private function number(corners:Vector.<int>):void
        {
            _indices = corners;
            _points = new Vector.<Number>();
            var count:int = corners.length;
            for (var i:int = 0; i < count; i++)
            {
                var from:int = 3 * corners[i];
                _points.push(_vertices[from], _vertices[from + 1], _vertices[from + 2]);
            }
        }

        // Where each corner's neighbours are to be: there are pairs of a corner and a neighbour of it.
        private function countNeighbors():void
        {
            var pairs:Vector.<int> = _pairs;
            var length:int = pairs.length;
            var count:int = _indices.length;
            var first:Vector.<int> = new Vector.<int>(count + 1);
            var i:int;
            for (i = 0; i < length; i += 2)
            {
                first[int(pairs[i] + 1)]++;
            }
            for (i = 0; i < count; i++)
            {
                first[i + 1] += first[i];
            }
            _firstNeighbor = first;
        }

        private function fillNeighbors():void
        {
            var pairs:Vector.<int> = _pairs;
            var length:int = pairs.length;
            var next:Vector.<int> = _firstNeighbor.concat();
            _neighbors = new Vector.<int>(length / 2);
            for (var i:int = 0; i < length; i += 2)
            {
                _neighbors[next[pairs[i]]++] = pairs[int(i + 1)];
            }
        }
    }
}
