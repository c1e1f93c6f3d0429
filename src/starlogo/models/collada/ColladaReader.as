package starlogo.models.collada
{
    import starlogo.models.Decimal;
    import starlogo.models.ModelBudget;
    import starlogo.models.ModelReader;
    import starlogo.models.TextTokens;
    import starlogo.models.TriangleLabels;
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads a COLLADA document. ColladaModel says which parts.
     *
     * @private
     */
    public final class ColladaReader extends ModelReader
    {
        private static const VERTICES_PER_STEP:int = 3000;
        private static const TRIANGLES_PER_STEP:int = 5000;

        // whether the caller has named the up axis
        private var _isAxisNamed:Boolean;

        private var _budget:ModelBudget;
        private var _xml:XmlReader;
        private var _document:ColladaDocument = null;
        private var _scene:ColladaScene = null;
        private var _instance:int = 0;

        /**
         * @param name the model's name
         * @param source the document's text
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the document as it is; null for the axis that the document names
         */
        public function ColladaReader(name:String, source:String, upAxis:Object)
        {
            super(name, upAxis == null ? "z" : upAxis);
            refuseIf(source == null, name, "there is no text to read");
            _isAxisNamed = upAxis != null;
            _budget = new ModelBudget(name, source.length);
            _xml = new XmlReader(source, _budget);
            add(_xml).begin(walking).beginEach(readingNext);
        }

        private function walking():Steps
        {
            _document = new ColladaDocument(_budget, _xml);
            _xml = null;
            var asset:ColladaElement = _document.root.child("asset");
            data.unit = unitOf(asset);
            _scene = new ColladaScene(_document, _isAxisNamed ? turnUp : turnFrom(upAxisOf(asset)));
            return _scene;
        }

        // The work that reads the next instance's mesh and places it. Null when there are no more.
        private function readingNext():Steps
        {
            if (_instance == _scene.instances.length)
            {
                takeVertices("a scene or a library with a geometry in it");
                return null;
            }
            var instance:ColladaInstance = _scene.instances[_instance];
            // each geometry is read once, even if it is in the scene many times
            var mesh:ColladaMesh = instance.geometry.mesh ||= new ColladaMesh(_document, instance.geometry);
            return new StepSequence().add(mesh).begin(function():Steps
                {
                    _instance++;
                    progress = 0.9 * _instance / _scene.instances.length;
                    return placing(mesh, instance, verticesFor(mesh.hasSurfaces));
                });
        }

        /**
         * The work that adds a mesh at an instance's place. If the instance's transform mirrors, the triangles' corner order is reversed.
         */
        private function placing(mesh:ColladaMesh, instance:ColladaInstance, out:Vector.<Number>):Steps
        {
            var firstVertex:int = out.length / 3;
            var firstCorner:int = data.triangles.length;
            var vertexCount:int = mesh.vertices.length / 3;
            var triangleCount:int = mesh.triangles.length / 3;
            _budget.requireMesh(firstVertex + vertexCount, firstCorner / 3 + triangleCount, instance.element);
            if (triangleCount > 0)
            {
                addLabels(mesh.symbols, instance, firstCorner / 3);
            }
            return new StepSequence().slices(vertexCount, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    var areFinite:Boolean = instance.transform.place(mesh.vertices, first, end, out, firstVertex + first);
                    refuseIf(!areFinite, name, "its transformed coordinates are too large: they are not finite numbers", instance.element);
                }).slices(triangleCount, TRIANGLES_PER_STEP, function(first:int, end:int):void
                {
                    addTriangles(mesh.triangles, 3 * first, 3 * end, firstVertex, firstCorner, instance.transform.isMirror);
                });
        }

        // An instance is a mesh with the name of its node. Its materials are those that it binds to the symbols of its geometry.
        private function addLabels(symbols:TriangleLabels, instance:ColladaInstance, firstTriangle:int):void
        {
            var element:ColladaElement = instance.element;
            var label:String = nameOf(element.name != "geometry" && element.parent != null ? element.parent : element) || nameOf(instance.geometry);
            data.meshes.begin(data.meshes.numberFor(String(data.meshes.names.length), label), firstTriangle);
            data.materials.begin(-1, firstTriangle);
            var bound:Vector.<int> = new Vector.<int>();
            for each (var symbol:String in symbols.names)
            {
                var material:ColladaElement = _document.materialOf(element, symbol);
                bound.push(material == null ? data.materials.numberFor(symbol, symbol) : data.materials.numberFor(material.id, nameOf(material)));
            }
            for (var i:int = 0; i < symbols.starts.length; i++)
            {
                data.materials.begin(symbols.numbers[i] < 0 ? -1 : bound[symbols.numbers[i]], firstTriangle + symbols.starts[i]);
            }
        }

        private static function nameOf(element:ColladaElement):String
        {
            return element.attribute("name") || element.id || null;
        }

        private function addTriangles(from:Vector.<uint>, first:int, last:int, firstVertex:int, firstCorner:int, isMirror:Boolean):void
        {
            var to:Vector.<uint> = data.triangles;
            var at:int = firstCorner + first;
            var second:int = isMirror ? 2 : 1;
            var third:int = 3 - second;
            for (var i:int = first; i < last; i += 3)
            {
                to[at] = from[i] + firstVertex;
                to[int(at + 1)] = from[int(i + second)] + firstVertex;
                to[int(at + 2)] = from[int(i + third)] + firstVertex;
                at += 3;
            }
        }

        // A unit that is no length counts as a metre.
        private static function unitOf(asset:ColladaElement):Number
        {
            var element:ColladaElement = asset == null ? null : asset.child("unit");
            var metres:Number = element == null ? 1 : Decimal.of(TextTokens.of(element.attribute("meter")).join(" "));
            return metres > 0 && metres < Infinity ? metres : 1;
        }

        private function upAxisOf(asset:ColladaElement):String
        {
            var element:ColladaElement = asset == null ? null : asset.child("up_axis");
            if (element == null)
            {
                return "y";
            }
            var text:String = element.words.join(" ");
            refuseIf(!/^[XYZ]_UP$/.test(text), _document.budget.name, "expected X_UP, Y_UP or Z_UP, but found \"" + TextTokens.shorten(text) +
                    "\"", element);
            return text.charAt(0).toLowerCase();
        }
    }
}
