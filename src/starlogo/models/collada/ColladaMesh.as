package starlogo.models.collada
{
    import starlogo.models.VertexFilter;
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Reads a COLLADA geometry, in small steps. Splines, solids and lines have no surface here. */
    internal final class ColladaMesh extends StepSequence
    {
        /** When it is read: the points that its surfaces use, or all if it has none. */
        public var vertices:Vector.<Number> = new Vector.<Number>();

        /** When it is read: three indices of points per triangle. */
        public var triangles:Vector.<uint> = new Vector.<uint>();

        /** When it is read: whether there are surfaces, even if they have no area. */
        public var hasSurfaces:Boolean = false;

        private var _document:ColladaDocument;
        private var _mesh:ColladaElement;
        private var _primitives:Vector.<ColladaElement> = new Vector.<ColladaElement>();
        private var _sources:Object = {}; // of positions, by the address that an input has; "#" is in front
        private var _points:Object = {};
        private var _isUsed:Vector.<uint> = new Vector.<uint>();

        /**
         * @param document the document
         * @param geometry the element
         */
        public function ColladaMesh(document:ColladaDocument, geometry:ColladaElement)
        {
            _document = document;
            _mesh = geometry.child("mesh") || geometry.child("convex_mesh");
            document.triangulator.setTarget(vertices, triangles);
            for each (var element:ColladaElement in _mesh == null ? new Vector.<ColladaElement>() : _mesh.children)
            {
                if (ColladaPrimitive.isSurface(element))
                {
                    _primitives.push(element);
                    begin(readingPrimitive);
                }
            }
            if (_primitives.length == 0)
            {
                begin(readingPoints);
            }
            begin(droppingUnused).call(letGo);
        }

        /** The work on a primitive, after that on its source, if that was not read yet. */
        private function readingPrimitive():Steps
        {
            var element:ColladaElement = _primitives.shift();
            var work:StepSequence = new StepSequence();
            var points:ColladaSource = pointsOf(positionSource(ColladaPrimitive.positionInput(_document, element)), work);
            return work.begin(function():Steps
                {
                    return new ColladaPrimitive(_document, element, points, _isUsed, triangles);
                });
        }

        /** Where there are no surfaces, the points are all that there is. */
        private function readingPoints():Steps
        {
            var work:StepSequence = new StepSequence();
            var element:ColladaElement = _mesh == null ? null : _mesh.child("vertices");
            if (element != null)
            {
                pointsOf(sourceOfVertices(element), work);
            }
            return work;
        }

        /** The source that an input leads to, directly or through an element "vertices". */
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
            var input:ColladaElement = _document.input(vertices, "POSITION");
            refuseIf(input == null, _document.modelName, "expected an <input> with the semantic POSITION", vertices);
            return _document.target(input, "source", ["source"], _mesh);
        }

        /** A source; the work of reading it is added, once, however many primitives have its points. */
        private function pointsOf(source:ColladaElement, work:StepSequence):ColladaSource
        {
            var key:String = "#" + source.id; // an id may be the name of a property that each Object has
            var points:ColladaSource = _points[key];
            if (points == null)
            {
                points = _points[key] = new ColladaSource(_document, source, vertices);
                work.add(points).call(function():void
                    {
                        _isUsed.length = vertices.length / 3;
                    });
            }
            return points;
        }

        private function droppingUnused():Steps
        {
            hasSurfaces = _isUsed.indexOf(1) >= 0;
            return hasSurfaces ? new VertexFilter(vertices, triangles, _isUsed) : null;
        }

        private function letGo():void
        {
            _isUsed.length = 0;
            _points = null;
        }
    }
}
