package starlogo.away3d
{
    import away3d.containers.ObjectContainer3D;
    import away3d.core.base.Geometry;
    import away3d.core.base.ISubGeometry;
    import away3d.entities.Mesh;
    import flash.utils.getQualifiedClassName;
    import starlogo.geometry.PointTable;
    import starlogo.models.ModelError;
    import starlogo.steps.StepSequence;

    /** Reads what Away3dModel takes, in steps of about a millisecond. */
    internal final class SourceReader extends StepSequence
    {
        private static const INDICES_PER_STEP:int = 900;

        private var _name:String;
        private var _source:Object;
        private var _parts:Vector.<GeometryPart> = new Vector.<GeometryPart>();
        private var _hasTriangles:Boolean = false;
        private var _points:PointTable;
        private var _triangles:Vector.<uint> = new Vector.<uint>();

        // How many parts are done, and of the one that is next: its data, how far it is read, and for each vertex the number
        // of its point, -1 where it has none yet.
        private var _part:int = 0;
        private var _next:int = 0;
        private var _data:Vector.<Number> = null;
        private var _indices:Vector.<uint> = null;
        private var _pointOf:Vector.<int>;

        /**
         * @param name what agents call the shape
         * @param source what Away3dModel takes
         */
        public function SourceReader(name:String, source:Object)
        {
            _name = name;
            _source = source;
            call(collect).repeat(readSome);
        }

        /** How much is read, from 0 to 1. */
        public function get progress():Number
        {
            var count:int = _data == null ? 0 : itemCount();
            var ofPart:Number = count == 0 ? 0 : _next / count;
            return _parts.length == 0 ? 0 : (_part + ofPart) / _parts.length;
        }

        /** x, y, z, ... with z up, when all is read. */
        public function get vertices():Vector.<Number>
        {
            return _points.coordinates;
        }

        /** Three vertex indices each, when all is read. */
        public function get triangles():Vector.<uint>
        {
            return _triangles;
        }

        private function collect():void
        {
            addSource(_source);
            var most:int = 0;
            for each (var part:GeometryPart in _parts)
            {
                most += part.geometry.numVertices;
                _hasTriangles ||= part.geometry.numTriangles > 0;
            }
            _points = new PointTable(most);
        }

        private function addSource(source:Object):void
        {
            if (source is ObjectContainer3D)
            {
                addTree(ObjectContainer3D(source), new NodeTransform());
            }
            else if (source is Geometry)
            {
                addGeometry(Geometry(source), new NodeTransform());
            }
            else if (source is ISubGeometry)
            {
                _parts.push(new GeometryPart(ISubGeometry(source), new NodeTransform()));
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
                throw error("expected an ObjectContainer3D, a Geometry, an ISubGeometry or a list of them, not "
                        + (source == null ? "null" : getQualifiedClassName(source).replace("::", ".")));
            }
        }

        private function addTree(node:ObjectContainer3D, place:NodeTransform):void
        {
            if (node is Mesh)
            {
                addGeometry(Mesh(node).geometry, place);
            }
            for (var i:int = 0; i < node.numChildren; i++)
            {
                var child:ObjectContainer3D = node.getChildAt(i);
                addTree(child, place.ofChild(child));
            }
        }

        private function addGeometry(geometry:Geometry, place:NodeTransform):void
        {
            for each (var part:ISubGeometry in geometry == null ? null : geometry.subGeometries)
            {
                _parts.push(new GeometryPart(part, place));
            }
        }

        /** A step through the parts; whether there is more of them. */
        private function readSome():Boolean
        {
            if (_part == _parts.length)
            {
                return false;
            }
            var part:GeometryPart = _parts[_part];
            if (_data == null)
            {
                open(part.geometry);
            }
            var end:int = Math.min(_next + INDICES_PER_STEP, itemCount());
            if (_hasTriangles)
            {
                readTriangles(part, end);
            }
            else
            {
                readPoints(part, end);
            }
            _next = end;
            if (_next == itemCount())
            {
                _data = null;
                _next = 0;
                _part++;
            }
            return _part < _parts.length;
        }

        private function open(geometry:ISubGeometry):void
        {
            var count:int = geometry.numVertices;
            _data = geometry.vertexData || new Vector.<Number>();
            _indices = geometry.indexData || new Vector.<uint>();
            if (count > 0 && geometry.vertexOffset + (count - 1) * geometry.vertexStride + 3 > _data.length)
            {
                throw error("a sub-geometry has " + count + " vertices, but only " + _data.length + " numbers for them");
            }
            if (_indices.length < 3 * geometry.numTriangles)
            {
                throw error("a sub-geometry has " + geometry.numTriangles + " triangles, but only " + _indices.length + " indices");
            }
            _pointOf = new Vector.<int>(count);
            for (var i:int = 0; i < count; i++)
            {
                _pointOf[i] = -1;
            }
        }

        // With triangles, what they do not use is not drawn; without any, all vertices count.
        private function itemCount():int
        {
            var geometry:ISubGeometry = _parts[_part].geometry;
            return _hasTriangles ? 3 * geometry.numTriangles : geometry.numVertices;
        }

        // The swap of y and z is a mirror, so that each triangle is turned over; under a mirror in the tree it already is.
        private function readTriangles(part:GeometryPart, end:int):void
        {
            var isMirrored:Boolean = part.place.isMirrored;
            var count:uint = _pointOf.length;
            for (var i:int = _next; i < end; i += 3)
            {
                var a:uint = _indices[i];
                var b:uint = _indices[i + (isMirrored ? 1 : 2)];
                var c:uint = _indices[i + (isMirrored ? 2 : 1)];
                if (Math.max(a, b, c) >= count)
                {
                    throw error("triangle " + i / 3 + " of a sub-geometry names vertex " + Math.max(a, b, c) + ", the last one is "
                            + (count - 1));
                }
                _triangles.push(pointOf(part, a), pointOf(part, b), pointOf(part, c));
            }
        }

        private function readPoints(part:GeometryPart, end:int):void
        {
            for (var i:int = _next; i < end; i++)
            {
                pointOf(part, i);
            }
        }

        private function pointOf(part:GeometryPart, vertex:int):int
        {
            if (_pointOf[vertex] < 0)
            {
                var at:int = part.geometry.vertexOffset + vertex * part.geometry.vertexStride;
                var x:Number = _data[at];
                var y:Number = _data[at + 1];
                var z:Number = _data[at + 2];
                var place:NodeTransform = part.place;
                _pointOf[vertex] = _points.indexOf(place.coordinate(0, x, y, z), place.coordinate(2, x, y, z), place.coordinate(1, x, y, z));
            }
            return _pointOf[vertex];
        }

        private function error(problem:String):ModelError
        {
            return new ModelError(_name || "", "", problem);
        }
    }
}
