package starlogo.away3d
{
    import away3d.containers.ObjectContainer3D;
    import away3d.core.base.Geometry;
    import away3d.core.base.ISubGeometry;
    import away3d.entities.Mesh;
    import flash.utils.getQualifiedClassName;
    import starlogo.geometry.PointTable;
    import starlogo.models.AffineTransform;
    import starlogo.models.ModelError;
    import starlogo.models.ModelReader;
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Reads the source of an Away3dModel, in steps of about a millisecond. */
    internal final class SourceReader extends ModelReader
    {
        private static const INDICES_PER_STEP:int = 900;

        // swaps y and z, which mirrors
        private static const SWAP:AffineTransform = new AffineTransform(new <Number>[1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0]);

        private var _source:Object;

        // the parts, and the transform of each to the engine's space
        private var _parts:Vector.<ISubGeometry> = new Vector.<ISubGeometry>();
        private var _places:Vector.<AffineTransform> = new Vector.<AffineTransform>();
        private var _hasTriangles:Boolean = false;
        private var _points:PointTable;

        // _part is the index of the present part. The others belong to it: its data, and for each vertex the index of its point, or -1 if it
        // has none yet.
        private var _part:int = -1;
        private var _geometry:ISubGeometry;
        private var _data:Vector.<Number>;
        private var _indices:Vector.<uint>;
        private var _pointOf:Vector.<int>;
        private var _point:Vector.<Number> = new Vector.<Number>(3, true);

        /**
         * @param name what agents call the shape
         * @param source as for Away3dModel
         */
        public function SourceReader(name:String, source:Object)
        {
            super(name || "");
            _source = source;
            begin(collect);
        }

        private function collect():Steps
        {
            addSource(_source);
            var most:int = 0;
            for each (var part:ISubGeometry in _parts)
            {
                most += part.numVertices;
                _hasTriangles ||= part.numTriangles > 0;
            }
            _points = new PointTable(most);
            data.vertices = _points.coordinates;
            var reading:StepSequence = new StepSequence();
            for each (part in _parts)
            {
                reading.call(open).slices(itemCountOf(part), INDICES_PER_STEP, _hasTriangles ? readTriangles : readVertices);
            }
            return reading;
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
                throw new ModelError(name, "", "expected an ObjectContainer3D, a Geometry, an ISubGeometry or a list of them, not "
                        + (source == null ? "null" : getQualifiedClassName(source).replace("::", ".")));
            }
        }

        private function addTree(node:ObjectContainer3D, place:AffineTransform):void
        {
            if (node is Mesh)
            {
                addGeometry(Mesh(node).geometry, place);
            }
            for (var i:int = 0; i < node.numChildren; i++)
            {
                var child:ObjectContainer3D = node.getChildAt(i);
                addTree(child, place.after(NodeTransform.of(child)));
            }
        }

        private function addGeometry(geometry:Geometry, place:AffineTransform):void
        {
            for each (var part:ISubGeometry in geometry == null ? null : geometry.subGeometries)
            {
                addPart(part, place);
            }
        }

        private function addPart(part:ISubGeometry, place:AffineTransform):void
        {
            _parts.push(part);
            _places.push(place);
        }

        // Begins with the next part.
        private function open():void
        {
            var geometry:ISubGeometry = _parts[++_part];
            _geometry = geometry;
            var count:int = geometry.numVertices;
            _data = geometry.vertexData || new Vector.<Number>();
            _indices = geometry.indexData || new Vector.<uint>();
            refuseIf(count > 0 && geometry.vertexOffset + (count - 1) * geometry.vertexStride + 3 > _data.length, name,
                    "a sub-geometry has " + count + " vertices, but only " + _data.length + " numbers for them");
            refuseIf(_indices.length < 3 * geometry.numTriangles, name,
                    "a sub-geometry has " + geometry.numTriangles + " triangles, but only " + _indices.length + " indices");
            _pointOf = new Vector.<int>(count);
            for (var i:int = 0; i < count; i++)
            {
                _pointOf[i] = -1;
            }
        }

        // With triangles, only the vertices that they use count, because others are not drawn. Without triangles, all vertices count.
        private function itemCountOf(part:ISubGeometry):int
        {
            return _hasTriangles ? 3 * part.numTriangles : part.numVertices;
        }

        // Notes that the items of the present part up to one are read.
        private function noteProgress(end:int):void
        {
            progress = (_part + end / itemCountOf(_geometry)) / _parts.length;
        }

        private function readVertices(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                pointOf(i);
            }
            noteProgress(end);
        }

        private function readTriangles(first:int, end:int):void
        {
            var isMirror:Boolean = _places[_part].isMirror;
            var count:uint = _pointOf.length;
            for (var i:int = first; i < end; i += 3)
            {
                var a:uint = _indices[i];
                var b:uint = _indices[i + (isMirror ? 2 : 1)];
                var c:uint = _indices[i + (isMirror ? 1 : 2)];
                if (Math.max(a, b, c) >= count)
                {
                    throw new ModelError(name, "", "triangle " + i / 3 + " of a sub-geometry names vertex " + Math.max(a, b, c) + ", the last one is "
                            + (count - 1));
                }
                data.triangles.push(pointOf(a), pointOf(b), pointOf(c));
            }
            noteProgress(end);
        }

        private function pointOf(vertex:int):int
        {
            if (_pointOf[vertex] < 0)
            {
                var at:int = _geometry.vertexOffset + vertex * _geometry.vertexStride;
                var point:Vector.<Number> = _point;
                for (var i:int = 0; i < 3; i++)
                {
                    point[i] = _data[at + i];
                }
                _places[_part].transformPoints(point, 0, 1, point, 0);
                _pointOf[vertex] = _points.indexOf(point[0], point[1], point[2]);
            }
            return _pointOf[vertex];
        }
    }
}
