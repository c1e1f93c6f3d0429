package starlogo.models.gltf
{
    import starlogo.models.FileLimits;
    import starlogo.steps.StepSequence;

    /** Adds the triangles of a primitive to a model, at the place of a node, in steps. The primitive's vertices are already added. */
    internal final class GltfTriangles extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 5000;

        internal static const TRIANGLES:int = 4;
        private static const STRIP:int = 5;
        private static const FAN:int = 6;

        private var _triangles:Vector.<uint>;
        private var _indices:GltfAccessor = null;
        private var _primitive:GltfJson;
        private var _mode:int;
        private var _vertices:GltfVertices;
        private var _firstCorner:int;

        /**
         * @param file the file
         * @param primitive the primitive
         * @param vertices its vertices; their steps come before this one's
         * @param triangles takes its triangles
         */
        public function GltfTriangles(file:GltfFile, primitive:GltfJson, vertices:GltfVertices, triangles:Vector.<uint>)
        {
            _triangles = triangles;
            _primitive = primitive;
            _mode = modeOf(primitive);
            _vertices = vertices;
            _firstCorner = triangles.length;
            var index:int = primitive.reference("indices", "accessors");
            if (index >= 0)
            {
                _indices = file.accessor(index, "SCALAR");
                _indices.json.refuseIf(!_indices.areIndices, "indices must be 5121, 5123 or 5125, and not normalized", "componentType");
                add(_indices);
            }
            var cornerCount:int = _indices == null ? _vertices.count : _indices.count;
            var triangleCount:int = _mode == TRIANGLES ? cornerCount / 3 : Math.max(0, cornerCount - 2);
            file.limits.require(FileLimits.TRIANGLES, _firstCorner / 3 + triangleCount, primitive.place);
            slices(triangleCount, TRIANGLES_PER_STEP, addTriangles);
        }

        /** The mode of a primitive. Points and lines have a mode below TRIANGLES. */
        internal static function modeOf(primitive:GltfJson):int
        {
            return primitive.whole("mode", FAN, TRIANGLES);
        }

        // Triangle n of a list has the corners 3n, 3n+1 and 3n+2. Triangle n of a fan has the corners n+1, n+2 and 0. In a strip, every
        // second triangle has its corner order reversed.
        private function addTriangles(first:int, end:int):void
        {
            var to:Vector.<uint> = _triangles;
            var at:int = _firstCorner + 3 * first;
            var isMirror:Boolean = _vertices.isMirror;
            for (var i:int = first; i < end; i++)
            {
                var a:int = _mode == TRIANGLES ? 3 * i : (_mode == FAN ? i + 1 : i);
                var b:int = a + 1;
                var c:int = _mode == FAN ? 0 : a + 2;
                var isReversed:Boolean = isMirror != (_mode == STRIP && (i & 1) == 1);
                to[at] = cornerAt(a);
                to[int(at + 1)] = cornerAt(isReversed ? c : b);
                to[int(at + 2)] = cornerAt(isReversed ? b : c);
                at += 3;
            }
        }

        private function cornerAt(corner:int):int
        {
            if (_indices == null)
            {
                return _vertices.firstVertex + corner;
            }
            var index:Number = _indices.numbers[corner];
            if (index >= _vertices.count)
            {
                throw _indices.json.error("element " + corner + " names vertex " + index + ": " + _primitive.place + " has " + _vertices.count);
            }
            return _vertices.firstVertex + int(index);
        }
    }
}
