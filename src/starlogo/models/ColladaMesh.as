package starlogo.models
{
    /** Reads a COLLADA geometry, in small steps. Splines, solids and lines have no surface here. */
    internal final class ColladaMesh
    {
        private var _document:ColladaDocument;
        private var _mesh:XML;
        private var _primitives:Array = [];
        private var _source:ColladaSource = null;
        private var _reading:ColladaPrimitive = null;
        private var _positions:Object = {};
        private var _hasPositions:Boolean = false;
        private var _vertices:Vector.<Number> = new Vector.<Number>();
        private var _isUsed:Vector.<uint> = new Vector.<uint>();
        private var _triangles:Vector.<uint> = new Vector.<uint>();
        private var _triangulator:Triangulator;
        private var _isRead:Boolean = false;

        /**
         * @param document the document
         * @param geometry the element
         */
        public function ColladaMesh(document:ColladaDocument, geometry:XML)
        {
            _document = document;
            _mesh = ColladaDocument.child(geometry, "mesh") || ColladaDocument.child(geometry, "convex_mesh");
            _triangulator = new Triangulator(_vertices, _triangles);
            for each (var element:XML in _mesh == null ? new XMLList() : _mesh.elements())
            {
                if (ColladaPrimitive.isSurface(element))
                {
                    _primitives.push(element);
                }
            }
        }

        /** When it is read: the points that its surfaces use, or all if it has none. */
        public function get vertices():Vector.<Number>
        {
            return _vertices;
        }

        /** When it is read: three indices of points per triangle. */
        public function get triangles():Vector.<uint>
        {
            return _triangles;
        }

        /** When it is read: whether there are surfaces, be it without area. */
        public function get hasSurfaces():Boolean
        {
            return _isUsed.indexOf(1) >= 0;
        }

        /**
         * Reads on.
         *
         * @return whether there is more to read
         */
        public function step():Boolean
        {
            if (_isRead)
            {
                return false;
            }
            if (_source != null)
            {
                _source = _source.step() ? _source : null;
            }
            else if (_reading != null)
            {
                _reading = _reading.step() ? _reading : null;
            }
            else if (_primitives.length > 0)
            {
                _reading = primitive(_primitives.shift());
            }
            else if (!_hasPositions)
            {
                addPoints();
            }
            else
            {
                finish();
            }
            return !_isRead;
        }

        private function primitive(element:XML):ColladaPrimitive
        {
            var source:XML = positionSource(ColladaPrimitive.positionInput(_document, element));
            var positions:ColladaPositions = positionsOf(source);
            return new ColladaPrimitive(_document, element, positions, _isUsed, _triangles, _triangulator);
        }

        /** The source that an input leads to, by way of an element "vertices" or not. */
        private function positionSource(input:XML):XML
        {
            var target:XML = _document.target(input, "source", ["vertices", "source"], _mesh);
            return target.localName() == "source" ? target : sourceOfVertices(target);
        }

        private function sourceOfVertices(vertices:XML):XML
        {
            for each (var input:XML in ColladaDocument.children(vertices, "input"))
            {
                if (input.@semantic == "POSITION")
                {
                    return _document.target(input, "source", ["source"], _mesh);
                }
            }
            throw _document.error(vertices, "expected an <input> with the semantic POSITION");
        }

        /** A source's points, which are read in the next steps; once, however many primitives have them. */
        private function positionsOf(source:XML):ColladaPositions
        {
            var key:String = "#" + source.@id; // an id may be the name of a property that each Object has
            if (_positions[key] == null)
            {
                var first:int = _vertices.length / 3;
                _source = new ColladaSource(_document, source, _vertices);
                _positions[key] = new ColladaPositions(first, _source.count);
                _isUsed.length = first + _source.count;
                _hasPositions = true;
            }
            return _positions[key];
        }

        private function finish():void
        {
            if (hasSurfaces)
            {
                VertexFilter.keepUsed(_vertices, _triangles, _isUsed);
            }
            _isRead = true;
        }

        /** The points of a geometry without surfaces. */
        private function addPoints():void
        {
            var element:XML = _mesh == null ? null : ColladaDocument.child(_mesh, "vertices");
            if (element != null)
            {
                positionsOf(sourceOfVertices(element));
            }
            _hasPositions = true;
        }
    }
}
