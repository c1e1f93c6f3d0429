package starlogo.models.collada
{
    import starlogo.data.keyOf;
    import starlogo.models.polygons.Triangulator;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Reads a COLLADA geometry, in small steps. Splines, solids and lines count as having no surface. */
    internal final class ColladaMesh extends StepSequence
    {
        /** The geometry's element. */
        public var geometry:ColladaElement;

        /** When all is read: its points. */
        public var points:Vector.<Number> = new Vector.<Number>();

        /** When all is read: three point indices for each triangle. */
        public var triangles:Vector.<uint> = new Vector.<uint>();

        /** When all is read: the symbol of each primitive's material; "" for none. */
        public var symbols:Vector.<String> = new Vector.<String>();

        /** When all is read: the first triangle of each primitive. */
        public var firstTriangles:Vector.<int> = new Vector.<int>();

        private var _meshElement:ColladaElement;
        private var _pointsOfSources:Object = {}; // by the source's id

        /** @param geometry the geometry's element */
        public function ColladaMesh(geometry:ColladaElement)
        {
            this.geometry = geometry;
            _meshElement = geometry.child("mesh") || geometry.child("convex_mesh");
            var triangulator:Triangulator = new Triangulator(geometry.budget, points, triangles);
            for each (var element:ColladaElement in _meshElement == null ? null : _meshElement.children)
            {
                if (ColladaPrimitive.isSurface(element))
                {
                    addPrimitive(element, triangulator);
                }
            }
            begin(readingPoints);
        }

        // Adds the work on a primitive, after that on its source.
        private function addPrimitive(element:ColladaElement, triangulator:Triangulator):void
        {
            begin(function():Steps
                {
                    symbols.push(element.attribute("material"));
                    firstTriangles.push(triangles.length / 3);
                    var positions:ColladaAccessor = pointsOf(positionSource(ColladaPrimitive.positionInput(element)));
                    return new StepSequence().add(positions).add(new ColladaPrimitive(element, positions, triangulator));
                });
        }

        // The steps that read all points, if there is no primitive.
        private function readingPoints():Steps
        {
            var element:ColladaElement = _meshElement == null || symbols.length > 0 ? null : _meshElement.child("vertices");
            return element == null ? null : pointsOf(sourceOfVertices(element));
        }

        // The source that an input refers to, directly or through an element "vertices".
        private function positionSource(input:ColladaElement):ColladaElement
        {
            var target:ColladaElement = input.target("source", ["vertices", "source"], _meshElement);
            return target.name == "source" ? target : sourceOfVertices(target);
        }

        private function sourceOfVertices(vertices:ColladaElement):ColladaElement
        {
            return vertices.requiredInput("POSITION").target("source", ["source"], _meshElement);
        }

        // The points of a source, which are read once: several primitives may share them.
        private function pointsOf(source:ColladaElement):ColladaAccessor
        {
            // the "#" keeps the key different from every property that each Object has
            return _pointsOfSources[keyOf(source.id)] ||= new ColladaAccessor(source, ColladaAccessor.NUMBERS, points);
        }
    }
}
