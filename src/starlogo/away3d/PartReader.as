package starlogo.away3d
{
    import away3d.core.base.ISubGeometry;
    import starlogo.geometry.AffineTransform;
    import starlogo.geometry.vertices.PointTable;
    import starlogo.models.ModelError;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads one sub-geometry of an Away3dModel's source. Only the vertices that triangles use become points of the model, because others are
     * not drawn. If the whole source has no triangles, all vertices become points.
     */
    internal final class PartReader
    {
        private static const INDICES_PER_STEP:int = 900;

        /** The number of vertices. */
        public var vertexCount:int;

        /** The number of triangles. */
        public var triangleCount:int;

        private var _name:String;
        private var _part:ISubGeometry;
        private var _transform:AffineTransform;

        // While it is read: the part's numbers, and the index of each vertex's point, -1 if the vertex is not read yet.
        private var _numbers:Vector.<Number>;
        private var _pointOf:Vector.<int>;

        // the coordinates of the vertex that is read
        private var _point:Vector.<Number> = new Vector.<Number>(3, true);

        /**
         * @param name the model's name
         * @param part the sub-geometry
         * @param transform takes its vertices to the engine's space
         */
        public function PartReader(name:String, part:ISubGeometry, transform:AffineTransform)
        {
            _name = name;
            _part = part;
            _transform = transform;
            vertexCount = part.numVertices;
            triangleCount = part.numTriangles;
        }

        /**
         * The work that reads all vertices.
         *
         * @param points receives them
         * @param setShare <code>function(share:Number):void</code>; gets the share that is read, from 0 to 1
         */
        public function readingVertices(points:PointTable, setShare:Function):Steps
        {
            open();
            return new StepSequence().slices(vertexCount, INDICES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        addPoint(i, points);
                    }
                    setShare(end / Math.max(1, vertexCount));
                });
        }

        /**
         * The work that reads the triangles, and the vertices that they use.
         *
         * @param points receives the vertices
         * @param triangles receives three indices of points for each triangle
         * @param setShare as for readingVertices()
         */
        public function readingTriangles(points:PointTable, triangles:Vector.<uint>, setShare:Function):Steps
        {
            var indices:Vector.<uint> = _part.indexData || new Vector.<uint>();
            open();
            refuseModelIf(indices.length < 3 * triangleCount, _name,
                    "a sub-geometry has " + triangleCount + " triangles, but only " + indices.length + " indices");
            return new StepSequence().slices(3 * triangleCount, INDICES_PER_STEP, function(first:int, end:int):void
                {
                    readTriangles(indices, first, end, points, triangles);
                    setShare(end / Math.max(1, 3 * triangleCount));
                });
        }

        private function open():void
        {
            _numbers = _part.vertexData || new Vector.<Number>();
            refuseModelIf(vertexCount > 0 && _part.vertexOffset + (vertexCount - 1) * _part.vertexStride + 3 > _numbers.length, _name,
                    "a sub-geometry has " + vertexCount + " vertices, but only " + _numbers.length + " numbers for them");
            _pointOf = new Vector.<int>(vertexCount);
            for (var i:int = 0; i < vertexCount; i++)
            {
                _pointOf[i] = -1;
            }
        }

        private function readTriangles(indices:Vector.<uint>, first:int, end:int, points:PointTable, triangles:Vector.<uint>):void
        {
            var isMirror:Boolean = _transform.isMirror;
            for (var i:int = first; i < end; i += 3)
            {
                var a:uint = indices[i];
                var b:uint = indices[i + (isMirror ? 2 : 1)];
                var c:uint = indices[i + (isMirror ? 1 : 2)];
                var most:uint = Math.max(a, b, c);
                if (most >= vertexCount)
                {
                    throw new ModelError(_name, "", "triangle " + i / 3 + " of a sub-geometry names vertex " + most + ", the last one is " + (vertexCount - 1));
                }
                triangles.push(addPoint(a, points), addPoint(b, points), addPoint(c, points));
            }
        }

        // Adds the point of a vertex, if it is not there yet. Returns its index.
        private function addPoint(vertex:int, points:PointTable):int
        {
            if (_pointOf[vertex] < 0)
            {
                var at:int = _part.vertexOffset + vertex * _part.vertexStride;
                _point[0] = _numbers[at];
                _point[1] = _numbers[int(at + 1)];
                _point[2] = _numbers[int(at + 2)];
                _transform.transformPoints(_point, 0, 1, _point, 0);
                _pointOf[vertex] = points.add(_point[0], _point[1], _point[2]);
            }
            return _pointOf[vertex];
        }
    }
}
