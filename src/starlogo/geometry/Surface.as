package starlogo.geometry
{
    /**
     * What a model's triangles are as a whole: whether they close, and how many pieces they come in. Vertices at the same
     * position count as one. Costs a few sorts and look-ups a triangle, once.
     */
    public final class Surface
    {
        /**
         * Whether the surface separates an inside from the outside: along every edge as many triangles run in one
         * direction as in the other, or, where they are not turned consistently, an even number of them meet. A surface
         * may close in several pieces, which may run into each other.
         */
        public var isClosed:Boolean;

        /**
         * Whether it closes with its triangles turned consistently. Then a point is inside where the surface winds around
         * it; otherwise where a ray from it crosses the surface an odd number of times.
         */
        public var isOriented:Boolean;

        /** One vertex of each connected piece: x, y, z. Pieces that touch but share no vertex are several. */
        public var seeds:Vector.<Number> = new Vector.<Number>();

        // The number of the first vertex at the position of each.
        private var _welded:Vector.<int>;
        private var _parents:Vector.<int>;

        /**
         * @param vertices x, y, z each
         * @param triangles three vertex indices each
         */
        public function Surface(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            weld(vertices);
            findPieces(vertices, triangles);
            findBorders(triangles);
            _welded = null;
            _parents = null;
        }

        private function weld(vertices:Vector.<Number>):void
        {
            var count:int = vertices.length / 3;
            var firstAt:Object = {};
            _welded = new Vector.<int>(count, true);
            for (var i:int = 0; i < count; i++)
            {
                var position:String = vertices[3 * i] + " " + vertices[3 * i + 1] + " " + vertices[3 * i + 2];
                var first:* = firstAt[position];
                if (first === undefined)
                {
                    firstAt[position] = first = i;
                }
                _welded[i] = first;
            }
        }

        private function findPieces(vertices:Vector.<Number>, triangles:Vector.<uint>):void
        {
            var count:int = _welded.length;
            _parents = new Vector.<int>(count, true);
            for (var i:int = 0; i < count; i++)
            {
                _parents[i] = i;
            }
            for (i = 0; i < triangles.length; i += 3)
            {
                var piece:int = pieceOf(_welded[triangles[i]]);
                _parents[pieceOf(_welded[triangles[int(i + 1)]])] = piece;
                _parents[pieceOf(_welded[triangles[int(i + 2)]])] = piece;
            }
            var isKnown:Vector.<Boolean> = new Vector.<Boolean>(count, true);
            for (i = 0; i < triangles.length; i += 3)
            {
                piece = pieceOf(_welded[triangles[i]]);
                if (!isKnown[piece])
                {
                    isKnown[piece] = true;
                    seeds.push(vertices[3 * piece], vertices[3 * piece + 1], vertices[3 * piece + 2]);
                }
            }
        }

        private function pieceOf(vertex:int):int
        {
            while (_parents[vertex] != vertex)
            {
                // shortens the way for the next one
                _parents[vertex] = _parents[_parents[vertex]];
                vertex = _parents[vertex];
            }
            return vertex;
        }

        // Edges as numbers, so that the native sort brings those of the same two vertices together.
        private function findBorders(triangles:Vector.<uint>):void
        {
            var edges:Array = [];
            for (var i:int = 0; i < triangles.length; i += 3)
            {
                var a:int = _welded[triangles[i]];
                var b:int = _welded[triangles[int(i + 1)]];
                var c:int = _welded[triangles[int(i + 2)]];
                if (a != b && b != c && c != a)
                {
                    edges.push(edge(a, b), edge(b, c), edge(c, a));
                }
            }
            edges.sort(Array.NUMERIC);
            isOriented = true;
            isClosed = edges.length > 0;
            for (i = 0; i < edges.length; i = next)
            {
                var pair:Number = Math.floor(edges[i] / 2);
                var balance:int = 0;
                for (var next:int = i; next < edges.length && Math.floor(edges[next] / 2) == pair; next++)
                {
                    balance += edges[next] == 2 * pair ? 1 : -1;
                }
                isOriented &&= balance == 0;
                isClosed &&= (next - i) % 2 == 0;
            }
        }

        private function edge(from:int, to:int):Number
        {
            var count:Number = _welded.length;
            return from < to ? 2 * (from * count + to) : 2 * (to * count + from) + 1;
        }
    }
}
