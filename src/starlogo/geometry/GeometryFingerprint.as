package starlogo.geometry
{
    import starlogo.steps.Steps;

    /**
     * Finds the fingerprint of a model's geometry in steps. Every triangle counts, and every vertex as a number that depends on all
     * of its coordinates: what moves a vertex by more than rounding does changes the fingerprint. It is made for speed: exact bits
     * would have to go through a ByteArray, which takes twice as long in Ruffle.
     *
     * @private
     */
    public final class GeometryFingerprint implements Steps
    {
        private static const VERTICES_A_STEP:int = 3000;

        // No model's sides are in such proportions. A vertex's number fills an integer, and what is left of it counts as well.
        private static const WEIGHT_X:Number = 0.7548776662466927 * 1073741824;
        private static const WEIGHT_Y:Number = 0.5698402909980532 * 1073741824;
        private static const WEIGHT_Z:Number = 0.4301597090019468 * 1073741824;

        private var _fingerprint:Fingerprint = new Fingerprint();
        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;
        private var _mix:int = 0;
        private var _rest:Number = 0;
        private var _nextVertex:int = 0;
        private var _nextTriangle:int = 0;

        /**
         * @param vertices x, y, z each
         * @param triangles three vertex indices each; null where there are none
         */
        public function GeometryFingerprint(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles == null ? new Vector.<uint>() : triangles;
            _fingerprint.addWord(_vertices.length);
            _fingerprint.addWord(_triangles.length);
        }

        /** What was found, when no step is left. */
        public function get fingerprint():Fingerprint
        {
            return _fingerprint;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            if (_nextVertex < _vertices.length)
            {
                addVertices();
            }
            else
            {
                addTriangles();
            }
            if (_nextVertex < _vertices.length || _nextTriangle < _triangles.length)
            {
                return true;
            }
            _fingerprint.addWord(_mix);
            _fingerprint.addNumber(_rest);
            return false;
        }

        private function addVertices():void
        {
            var vertices:Vector.<Number> = _vertices;
            var end:int = Math.min(_nextVertex + 3 * VERTICES_A_STEP, vertices.length);
            var mix:int = _mix;
            var rest:Number = _rest;
            var weightX:Number = WEIGHT_X;
            var weightY:Number = WEIGHT_Y;
            var weightZ:Number = WEIGHT_Z;
            var i:int = _nextVertex;
            while (i < end)
            {
                var place:Number = vertices[i++] * weightX;
                place += vertices[i++] * weightY;
                place += vertices[i++] * weightZ;
                var whole:int = place;
                rest += place - whole;
                mix ^= whole;
                mix += mix << 10;
                mix ^= mix >>> 6;
            }
            _mix = mix;
            _rest = rest;
            _nextVertex = end;
        }

        private function addTriangles():void
        {
            var triangles:Vector.<uint> = _triangles;
            var end:int = Math.min(_nextTriangle + 6 * VERTICES_A_STEP, triangles.length);
            var mix:int = _mix;
            var i:int = _nextTriangle;
            while (i < end)
            {
                var place:Number = triangles[i++];
                place += triangles[i++] * 65599;
                place += triangles[i++] * 8261505;
                var whole:int = place;
                mix ^= whole;
                mix += mix << 10;
                mix ^= mix >>> 6;
            }
            _mix = mix;
            _nextTriangle = end;
        }
    }
}
