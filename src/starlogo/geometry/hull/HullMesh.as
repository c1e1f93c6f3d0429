package starlogo.geometry.hull
{
    import starlogo.steps.StepSequence;

    /**
     * How the corners of a hull are joined: made of its triangles, or of a loop of corners that has none. ConvexHull says what each
     * result is; they are there when no step is left.
     *
     * @private
     */
    public final class HullMesh extends StepSequence
    {
        /** See ConvexHull, here as below. */
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

        // where each vertex is among the corners; and each corner beside a neighbour of it, in pairs
        private var _place:Vector.<int>;
        private var _pairs:Vector.<int> = new Vector.<int>();

        /**
         * @param vertices x, y, z each
         * @param corners positions among the vertices: three for each triangle, or a loop of corners, the last joined to the first
         * @param areTriangles which of the two
         */
        public function HullMesh(vertices:Vector.<Number>, corners:Vector.<int>, areTriangles:Boolean)
        {
            _vertices = vertices;
            _corners = corners;
            call(numberCorners).call(areTriangles ? joinTriangles : joinLoop).call(countNeighbors).call(fillNeighbors);
        }

        private function numberCorners():void
        {
            var corners:Vector.<int> = _corners;
            var vertexCount:int = _vertices.length / 3;
            var place:Vector.<int> = new Vector.<int>(vertexCount);
            var count:int = corners.length;
            var i:int;
            for (i = 0; i < count; i++)
            {
                place[corners[i]] = 1;
            }
            for (i = 0; i < vertexCount; i++)
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
            var corners:Vector.<int> = _corners;
            var pairs:Vector.<int> = _pairs;
            var count:int = corners.length;
            triangles.length = count;
            pairs.length = 2 * count;
            for (var i:int = 0; i < count; i += 3)
            {
                var a:int = _place[corners[i]];
                var b:int = _place[corners[int(i + 1)]];
                var c:int = _place[corners[int(i + 2)]];
                triangles[i] = pairs[2 * i] = pairs[2 * i + 5] = a;
                triangles[i + 1] = pairs[2 * i + 1] = pairs[2 * i + 2] = b;
                triangles[i + 2] = pairs[2 * i + 3] = pairs[2 * i + 4] = c;
            }
        }

        private function joinLoop():void
        {
            var count:int = _corners.length;
            for (var i:int = 0; i < count && count > 1; i++)
            {
                var corner:int = _place[_corners[i]];
                var next:int = _place[_corners[(i + 1) % count]];
                _pairs.push(corner, next);
                if (count > 2)
                {
                    _pairs.push(next, corner);
                }
            }
        }

        // Where each corner's neighbours are to be: there are pairs of a corner and a neighbour of it.
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
