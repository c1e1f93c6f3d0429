package starlogo.models
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Reads a COLLADA geometry, in small steps. Splines, solids and lines have no surface here. */
    internal final class ColladaMesh implements Steps
    {
        private var _document:ColladaDocument;
        private var _mesh:ColladaElement;
        private var _primitives:Vector.<ColladaElement> = new Vector.<ColladaElement>();
        private var _sources:Object = {}; // of positions, by the address that an input has; "#" is in front
        private var _points:Object = {};
        private var _vertices:Vector.<Number> = new Vector.<Number>();
        private var _isUsed:Vector.<uint> = new Vector.<uint>();
        private var _triangles:Vector.<uint> = new Vector.<uint>();
        private var _triangulator:Triangulator;
        private var _work:StepSequence = new StepSequence();
        private var _isRead:Boolean = false;
        private var _hasSurfaces:Boolean = false;

        /**
         * @param document the document
         * @param geometry the element
         */
        public function ColladaMesh(document:ColladaDocument, geometry:ColladaElement)
        {
            _document = document;
            _mesh = geometry.child("mesh") || geometry.child("convex_mesh");
            _triangulator = new Triangulator(_vertices, _triangles, document.triangulation);
            for each (var element:ColladaElement in _mesh == null ? new Vector.<ColladaElement>() : _mesh.children)
            {
                if (ColladaPrimitive.isSurface(element))
                {
                    _primitives.push(element);
                    _work.begin(nextPrimitive);
                }
            }
            if (_primitives.length == 0)
            {
                _work.begin(readPoints);
            }
            _work.begin(dropUnused).call(conclude);
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
            return _hasSurfaces;
        }

        /** @inheritDoc A mesh that is read may be asked again: it says that there is no more. */
        public function step():Boolean
        {
            return !_isRead && _work.step();
        }

        /** The work on a primitive, after that on its source, if that was not read yet. */
        private function nextPrimitive():Steps
        {
            var element:ColladaElement = _primitives.shift();
            var work:StepSequence = new StepSequence();
            var source:ColladaElement = positionSource(ColladaPrimitive.positionInput(_document, element));
            var points:ColladaSource = pointsOf(source, work);
            return work.begin(function():Steps
                {
                    return new ColladaPrimitive(_document, element, points, _isUsed, _triangles, _triangulator);
                });
        }

        /** Where there are no surfaces, the points are all that there is. */
        private function readPoints():Steps
        {
            var work:StepSequence = new StepSequence();
            var element:ColladaElement = _mesh == null ? null : _mesh.child("vertices");
            if (element != null)
            {
                pointsOf(sourceOfVertices(element), work);
            }
            return work;
        }

        /** The source that an input leads to, by way of an element "vertices" or not. */
        private function positionSource(input:ColladaElement):ColladaElement
        {
            var url:String = input.attribute("source");
            if (!_sources.hasOwnProperty(url))
            {
                var target:ColladaElement = _document.target(input, "source", ["vertices", "source"], _mesh);
                _sources[url] = target.name == "source" ? target : sourceOfVertices(target);
            }
            return _sources[url];
        }

        private function sourceOfVertices(vertices:ColladaElement):ColladaElement
        {
            for each (var input:ColladaElement in vertices.childrenNamed("input"))
            {
                if (input.attribute("semantic") == "POSITION")
                {
                    return _document.target(input, "source", ["source"], _mesh);
                }
            }
            throw _document.error(vertices, "expected an <input> with the semantic POSITION");
        }

        /** A source; the work of reading it is added, once, however many primitives have its points. */
        private function pointsOf(source:ColladaElement, work:StepSequence):ColladaSource
        {
            var key:String = "#" + source.id; // an id may be the name of a property that each Object has
            var points:ColladaSource = _points[key];
            if (points == null)
            {
                points = _points[key] = new ColladaSource(_document, source, _vertices);
                work.add(points).call(function():void
                    {
                        _isUsed.length = _vertices.length / 3;
                    });
            }
            return points;
        }

        private function dropUnused():Steps
        {
            _hasSurfaces = _isUsed.indexOf(1) >= 0;
            return _hasSurfaces ? new VertexFilter(_vertices, _triangles, _isUsed) : null;
        }

        private function conclude():void
        {
            _isUsed.length = 0;
            _points = null;
            _isRead = true;
        }
    }
}
