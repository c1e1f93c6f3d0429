package starlogo.geometry
{
    import starlogo.steps.StepSequence;

    /**
     * Finds the fingerprint of a model's geometry in steps. Every triangle counts, and every vertex as a number that depends on all
     * of its coordinates: what moves a vertex by more than rounding does changes the fingerprint. It is made for speed: exact bits
     * would have to go through a ByteArray, which takes twice as long in Ruffle.
     *
     * @private
     */
    public final class GeometryFingerprint extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 3000;
        private static const TRIANGLES_PER_STEP:int = 6000;

        // Weights in proportions that no model's sides have. A vertex's number fills an integer, and its fraction counts as well.
        private static const WEIGHT_X:Number = 0.7548776662466927 * 1073741824;
        private static const WEIGHT_Y:Number = 0.5698402909980532 * 1073741824;
        private static const WEIGHT_Z:Number = 0.4301597090019468 * 1073741824;

        /** The fingerprint, when no step is left. */
        public var fingerprint:Fingerprint = new Fingerprint();
        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;
        private var _mix:int = 0;
        private var _rest:Number = 0;

        /**
         * @param vertices x, y, z each
         * @param triangles three vertex indices each; null where there are none
         */
        public function GeometryFingerprint(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles == null ? new Vector.<uint>() : triangles;
            fingerprint.addWord(_vertices.length);
            fingerprint.addWord(_triangles.length);
            slices(vertices.length / 3, VERTICES_PER_STEP, addVertices).slices(_triangles.length / 3, TRIANGLES_PER_STEP, addTriangles)
                .call(conclude);
        }

        private function addVertices(first:int, end:int):void
        {
            var vertices:Vector.<Number> = _vertices;
            var mix:int = _mix;
            var rest:Number = _rest;
            var weightX:Number = WEIGHT_X;
            var weightY:Number = WEIGHT_Y;
            var weightZ:Number = WEIGHT_Z;
            var i:int = 3 * first;
            var last:int = 3 * end;
            while (i < last)
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
        }

        private function addTriangles(first:int, end:int):void
        {
            var triangles:Vector.<uint> = _triangles;
            var mix:int = _mix;
            var i:int = 3 * first;
            var last:int = 3 * end;
            while (i < last)
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
        }

        private function conclude():void
        {
            fingerprint.addWord(_mix);
            fingerprint.addNumber(_rest);
        }
    }
}
