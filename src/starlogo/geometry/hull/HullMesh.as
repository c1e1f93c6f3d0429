package starlogo.geometry.hull
{
    import starlogo.steps.StepSequence;

    /**
     * The corners of a hull, and how they are connected. ConvexHull describes the results. They are complete after the last step.
     *
     * @private
     */
    public final class HullMesh extends StepSequence
    {
        /** See the property of ConvexHull with the same name. */
        public var indices:Vector.<int> = new Vector.<int>();

        /** @copy #indices */
        public var points:Vector.<Number> = new Vector.<Number>();

        /** @copy #indices */
        public var triangles:Vector.<int> = new Vector.<int>();

        /** @copy #indices */
        public var firstNeighbor:Vector.<int>;

        /** @copy #indices */
        public var neighbors:Vector.<int>;

        private var _vertices:Vector.<Number>;
        private var _corners:Vector.<int>;
        private var _apex:int;

        // The position of each vertex among the corners. Pairs of a corner and a neighbour of it.
        private var _place:Vector.<int>;
        private var _pairs:Vector.<int> = new Vector.<int>();

        /**
         * @param vertices x, y, z of each
         * @param corners the triangles' corners, as indices of vertices. The index after the last vertex stands for an extra point
         *     outside of vertices without volume. Triangles and edges with this point are ignored
         */
        public function HullMesh(vertices:Vector.<Number>, corners:Vector.<int>)
        {
            _vertices = vertices;
            _corners = corners;
            _apex = vertices.length / 3;
            call(numberCorners).call(joinTriangles).call(countNeighbors).call(fillNeighbors);
        }

        private function numberCorners():void
        {
            var corners:Vector.<int> = _corners;
            var place:Vector.<int> = new Vector.<int>(_apex + 1);
            var count:int = corners.length;
            var i:int;
            for (i = 0; i < count; i++)
            {
                place[corners[i]] = 1;
            }
            for (i = 0; i < _apex; i++)
            {
                if (place[i] == 1)
                {
                    place[i] = indices.length;
                    indices.push(i);
                    points.push(_vertices[3 * i], _vertices[3 * i + 1], _vertices[3 * i + 2]);
                }
            }
            _place = place;
        }

        private function joinTriangles():void
        {
            for (var i:int = 0; i < _corners.length; i += 3)
            {
                var a:int = _corners[i];
                var b:int = _corners[int(i + 1)];
                var c:int = _corners[int(i + 2)];
                join(a, b);
                join(b, c);
                join(c, a);
                if (a != _apex && b != _apex && c != _apex)
                {
                    triangles.push(_place[a], _place[b], _place[c]);
                }
            }
        }

        private function join(from:int, to:int):void
        {
            if (from != _apex && to != _apex)
            {
                _pairs.push(_place[from], _place[to]);
            }
        }

        // Finds where each corner's neighbours begin, from the pairs of a corner and a neighbour.
        private function countNeighbors():void
        {
            var pairs:Vector.<int> = _pairs;
            var length:int = pairs.length;
            var count:int = indices.length;
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
            firstNeighbor = first;
        }

        private function fillNeighbors():void
        {
            var pairs:Vector.<int> = _pairs;
            var length:int = pairs.length;
            var next:Vector.<int> = firstNeighbor.concat();
            neighbors = new Vector.<int>(length / 2);
            for (var i:int = 0; i < length; i += 2)
            {
                neighbors[next[pairs[i]]++] = pairs[int(i + 1)];
            }
        }
    }
}
