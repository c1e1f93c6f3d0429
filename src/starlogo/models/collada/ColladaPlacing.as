package starlogo.models.collada
{
    import starlogo.models.ModelLimits;
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;

    /** Adds a mesh to a model where an instance of it is, in steps. */
    internal final class ColladaPlacing extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 3000;
        private static const TRIANGLES_PER_STEP:int = 5000;

        private var _document:ColladaDocument;
        private var _mesh:ColladaMesh;
        private var _instance:ColladaInstance;
        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;
        private var _firstVertex:int;
        private var _firstCorner:int;

        /**
         * @param document what it is of
         * @param mesh a mesh that is read
         * @param instance where it is
         * @param vertices where its points go, after those that are there: x, y, z, ...
         * @param triangles where its triangles go
         * @throws ModelError if that would be more than a model may have; the steps, if coordinates are not finite
         */
        public function ColladaPlacing(document:ColladaDocument, mesh:ColladaMesh, instance:ColladaInstance, vertices:Vector.<Number>,
                triangles:Vector.<uint>)
        {
            _document = document;
            _mesh = mesh;
            _instance = instance;
            _vertices = vertices;
            _triangles = triangles;
            _firstVertex = vertices.length / 3;
            _firstCorner = triangles.length;
            var vertexCount:int = mesh.vertices.length / 3;
            var triangleCount:int = mesh.triangles.length / 3;
            refuseIf(ModelLimits.areExceeded(_firstVertex + vertexCount, _firstCorner / 3 + triangleCount), document.modelName, ModelLimits.PROBLEM, instance.element);
            vertices.length += 3 * vertexCount;
            triangles.length += 3 * triangleCount;
            slices(vertexCount, VERTICES_PER_STEP, placeVertices).slices(triangleCount, TRIANGLES_PER_STEP, placeTriangles);
        }

        private function placeVertices(first:int, end:int):void
        {
            var areFinite:Boolean = _instance.transform.place(_mesh.vertices, first, end, _vertices, _firstVertex + first);
            refuseIf(!areFinite, _document.modelName, "its transformed coordinates are too large to be finite numbers", _instance.element);
        }

        private function placeTriangles(first:int, end:int):void
        {
            var from:Vector.<uint> = _mesh.triangles;
            var to:Vector.<uint> = _triangles;
            var firstVertex:int = _firstVertex;
            var at:int = _firstCorner + 3 * first;
            var second:int = _instance.transform.isMirror ? 2 : 1;
            var third:int = 3 - second;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                to[at] = from[i] + firstVertex;
                to[int(at + second)] = from[int(i + 1)] + firstVertex;
                to[int(at + third)] = from[int(i + 2)] + firstVertex;
                at += 3;
            }
        }
    }
}
