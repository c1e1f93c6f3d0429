package starlogo.models.gltf
{
    import starlogo.steps.StepSequence;

    /** Adds the triangles of a primitive to a model, at the place of a node, in steps. The primitive's vertices are already added. */
    internal final class GltfTriangles extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 5000;

        internal static const TRIANGLES:int = 4;
        private static const STRIP:int = 5;
        private static const FAN:int = 6;

        private var _indices:GltfAccessor = null;
        private var _primitive:GltfJson;
        private var _vertices:GltfVertices;

        /**
         * @param file the file
         * @param primitive the primitive
         * @param vertices its vertices; their steps come before this one's
         * @param triangles takes its triangles
         */
        public function GltfTriangles(file:GltfFile, primitive:GltfJson, vertices:GltfVertices, triangles:Vector.<uint>)
        {
            _primitive = primitive;
            _vertices = vertices;
            var index:int = primitive.indexOrNone("indices", "accessors");
            if (index >= 0)
            {
                _indices = file.accessor(index, "SCALAR");
                _indices.json.refuseIf(!_indices.areIndices, "indices must be 5121, 5123 or 5125, and not normalized", "componentType");
                add(_indices);
            }
            var cornerCount:int = _indices == null ? _vertices.count : _indices.count;
            var mode:int = modeOf(primitive);
            var triangleCount:int = mode == TRIANGLES ? cornerCount / 3 : Math.max(0, cornerCount - 2);
            file.budget.checkMeshSize(0, triangles.length / 3 + triangleCount, primitive.place);
            slices(triangleCount, TRIANGLES_PER_STEP, function(first:int, end:int):void
                {
                    addTriangles(mode, first, end, triangles);
                });
        }

        /** The mode of a primitive. Points and lines have a mode below TRIANGLES. */
        internal static function modeOf(primitive:GltfJson):int
        {
            return primitive.integer("mode", FAN, TRIANGLES);
        }

        // Adds some triangles. Triangle n of a list has the corners 3n, 3n+1 and 3n+2. Triangle n of a fan has the corners n+1, n+2 and 0. In a
        // strip, every second triangle has its corner order reversed.
        private function addTriangles(mode:int, first:int, end:int, to:Vector.<uint>):void
        {
            var at:int = to.length;
            var isMirror:Boolean = _vertices.isMirror;
            for (var i:int = first; i < end; i++)
            {
                var a:int = mode == TRIANGLES ? 3 * i : (mode == FAN ? i + 1 : i);
                var b:int = a + 1;
                var c:int = mode == FAN ? 0 : a + 2;
                var isReversed:Boolean = isMirror != (mode == STRIP && (i & 1) == 1);
                to[at] = vertexAt(a);
                to[int(at + 1)] = vertexAt(isReversed ? c : b);
                to[int(at + 2)] = vertexAt(isReversed ? b : c);
                at += 3;
            }
        }

        private function vertexAt(corner:int):int
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
