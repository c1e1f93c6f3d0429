package starlogo.geometry
{
    import flash.utils.ByteArray;
    import starlogo.steps.StepSequence;

    /**
     * Computes the fingerprint of a model's geometry in steps. It depends on every bit of every vertex and triangle.
     *
     * @private
     */
    public final class GeometryFingerprint extends StepSequence
    {
        private static const NUMBERS_PER_STEP:int = 5000;

        /** The fingerprint. Complete after the last step. */
        public var fingerprint:Fingerprint = new Fingerprint();

        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;

        /**
         * @param vertices x, y, z of each
         * @param triangles three vertex indices each; null if there are none
         */
        public function GeometryFingerprint(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles == null ? new Vector.<uint>() : triangles;
            fingerprint.addWord(_vertices.length);
            slices(_vertices.length, NUMBERS_PER_STEP, addVertices).slices(_triangles.length, NUMBERS_PER_STEP, addTriangles);
        }

        private function addVertices(first:int, end:int):void
        {
            var bytes:ByteArray = new ByteArray();
            for (var i:int = first; i < end; i++)
            {
                bytes.writeDouble(_vertices[i]);
            }
            bytes.position = 0;
            fingerprint.addBytes(bytes, end - first);
        }

        private function addTriangles(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                fingerprint.addWord(_triangles[i]);
            }
        }
    }
}
