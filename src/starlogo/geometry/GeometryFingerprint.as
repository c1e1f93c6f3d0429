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

        // no model's sides are in such proportions
        private static const WEIGHT_X:Number = 0.7548776662466927;
        private static const WEIGHT_Y:Number = 0.5698402909980532;
        private static const WEIGHT_Z:Number = 0.4301597090019468;

        // what is left of a number without its first 30 bits counts as well
        private static const UNIT:Number = 1073741824;

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
            for (var i:int = _nextVertex; i < end; i += 3)
            {
                var place:Number = (vertices[i] * WEIGHT_X + vertices[int(i + 1)] * WEIGHT_Y + vertices[int(i + 2)] * WEIGHT_Z) * UNIT;
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
            for (var i:int = _nextTriangle; i < end; i += 3)
            {
                mix ^= triangles[i] ^ triangles[int(i + 1)] << 11 ^ triangles[int(i + 2)] << 21;
                mix += mix << 10;
                mix ^= mix >>> 6;
            }
            _mix = mix;
            _nextTriangle = end;
        }
    }
}
