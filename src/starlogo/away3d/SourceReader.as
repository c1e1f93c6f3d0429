package starlogo.away3d
{
    import away3d.containers.ObjectContainer3D;
    import away3d.core.base.Geometry;
    import away3d.core.base.ISubGeometry;
    import away3d.entities.Mesh;
    import flash.utils.getQualifiedClassName;
    import starlogo.geometry.AffineTransform;
    import starlogo.geometry.vertices.PointTable;
    import starlogo.models.Model;
    import starlogo.models.ModelError;
    import starlogo.models.building.ModelReader;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads the source of an Away3dModel, in steps of about a millisecond. Only the vertices that triangles use become points of the model, because
     * others are not drawn. If the whole source has no triangles, all vertices become points.
     */
    internal final class SourceReader extends ModelReader
    {
        // swaps y and z, which mirrors
        private static const SWAP:AffineTransform = new AffineTransform(new <Number>[1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0]);

        private static const INDICES_PER_STEP:int = 900;

        // the sub-geometries, and what takes the vertices of each to the engine's space
        private var _parts:Vector.<ISubGeometry> = new Vector.<ISubGeometry>();
        private var _transforms:Vector.<AffineTransform> = new Vector.<AffineTransform>();

        /** The parameters are those of Away3dModel. */
        public function SourceReader(name:String, object:Object)
        {
            super(name, "z", Model.FOOTPRINT);
            begin(function():Steps
                {
                    addSource(object);
                    return readingParts();
                });
        }

        private function readingParts():Steps
        {
            var vertexCount:int = 0;
            var hasTriangles:Boolean = false;
            for each (var part:ISubGeometry in _parts)
            {
                vertexCount += part.numVertices;
                hasTriangles ||= part.numTriangles > 0;
            }
            var points:PointTable = new PointTable(vertexCount);
            data.vertices = points.coordinates;
            return new StepSequence().beginEach(_parts.length, function(index:int):Steps
                {
                    return readingPart(index, points, hasTriangles);
                });
        }

        // The work that reads the triangles of a sub-geometry and the vertices that they use, or without triangles all vertices.
        private function readingPart(index:int, points:PointTable, hasTriangles:Boolean):Steps
        {
            var part:ISubGeometry = _parts[index];
            var transform:AffineTransform = _transforms[index];
            var isMirror:Boolean = transform.isMirror;
            var numbers:Vector.<Number> = part.vertexData || new Vector.<Number>();
            var indices:Vector.<uint> = part.indexData || new Vector.<uint>();
            var vertexCount:int = part.numVertices;
            var count:int = hasTriangles ? 3 * part.numTriangles : vertexCount;
            refuseModelIf(vertexCount > 0 && part.vertexOffset + (vertexCount - 1) * part.vertexStride + 3 > numbers.length, data.name,
                    "a sub-geometry has " + vertexCount + " vertices, but only " + numbers.length + " numbers for them");
            refuseModelIf(hasTriangles && indices.length < count, data.name,
                    "a sub-geometry has " + part.numTriangles + " triangles, but only " + indices.length + " indices");
            // the index of each vertex's point, plus 1; 0 before the vertex is read
            var pointOf:Vector.<int> = new Vector.<int>(vertexCount);
            var point:Vector.<Number> = new Vector.<Number>(3, true);
            return new StepSequence().slices(count, INDICES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        // in a mirror image, the second and the third corner of a triangle change places
                        var corner:int = isMirror && i % 3 != 0 ? i + 3 - 2 * (i % 3) : i;
                        var vertex:uint = hasTriangles ? indices[corner] : i;
                        if (vertex >= vertexCount)
                        {
                            throw new ModelError(data.name, "", "triangle " + int(i / 3) + " of a sub-geometry names vertex " + vertex + ", the last one is " + (vertexCount - 1));
                        }
                        if (pointOf[vertex] == 0)
                        {
                            var at:int = part.vertexOffset + vertex * part.vertexStride;
                            point[0] = numbers[at];
                            point[1] = numbers[int(at + 1)];
                            point[2] = numbers[int(at + 2)];
                            transform.transformPoints(point, 0, 1, point, 0);
                            pointOf[vertex] = points.add(point[0], point[1], point[2]) + 1;
                        }
                        if (hasTriangles)
                        {
                            data.triangles.push(pointOf[vertex] - 1);
                        }
                    }
                    progress = (index + end / Math.max(1, count)) / _parts.length;
                });
        }

        private function addSource(source:Object):void
        {
            if (source is ObjectContainer3D)
            {
                addTree(ObjectContainer3D(source), SWAP);
            }
            else if (source is Geometry)
            {
                addGeometry(Geometry(source), SWAP);
            }
            else if (source is ISubGeometry)
            {
                addPart(ISubGeometry(source), SWAP);
            }
            else if (source is Array || source is Vector.<*>)
            {
                for each (var each:Object in source)
                {
                    addSource(each);
                }
            }
            else
            {
                throw new ModelError(data.name, "", "expected an ObjectContainer3D, a Geometry, an ISubGeometry or a list of them, not "
                        + (source == null ? "null" : getQualifiedClassName(source).replace("::", ".")));
            }
        }

        private function addTree(node:ObjectContainer3D, transform:AffineTransform):void
        {
            if (node is Mesh)
            {
                addGeometry(Mesh(node).geometry, transform);
            }
            for (var i:int = 0; i < node.numChildren; i++)
            {
                var child:ObjectContainer3D = node.getChildAt(i);
                addTree(child, transform.after(NodeTransform.of(child)));
            }
        }

        private function addGeometry(geometry:Geometry, transform:AffineTransform):void
        {
            for each (var part:ISubGeometry in geometry == null ? null : geometry.subGeometries)
            {
                addPart(part, transform);
            }
        }

        private function addPart(part:ISubGeometry, transform:AffineTransform):void
        {
            _parts.push(part);
            _transforms.push(transform);
        }
    }
}
