package starlogo.models.collada
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.models.FileLimits;
    import starlogo.models.Model;
    import starlogo.models.ModelData;
    import starlogo.models.ModelBuilder;
    import starlogo.models.ModelTransform;
    import starlogo.models.refuseIf;
    import starlogo.models.shortened;
    import starlogo.models.text.Decimal;
    import starlogo.models.text.TextWords;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Reads a COLLADA document. ColladaModel says which parts.
     *
     * <p>An XmlReader makes ColladaElements of the text. A ColladaScene finds the geometries and where nodes place them. Each geometry is
     * a ColladaMesh, whose points come from a ColladaSource and whose triangles from ColladaPrimitives. Each place is a ColladaInstance, whose
     * mesh is added to the model.</p>
     *
     * @private
     */
    public final class ColladaReader extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 3000;
        private static const TRIANGLES_PER_STEP:int = 5000;

        private var _data:ModelData;

        /**
         * @param data takes what is read
         * @param text the document's text
         * @param isAxisNamed whether the axis that points up in the data counts, instead of the one that the document names
         */
        public function ColladaReader(data:ModelData, text:String, isAxisNamed:Boolean)
        {
            _data = data;
            refuseIf(text == null, data.name, "there is no text to read");
            var xml:XmlReader = new XmlReader(text, new FileLimits(data.name, text.length));
            add(xml).begin(function():Steps
                {
                    return readingDocument(xml.root, isAxisNamed);
                });
        }

        /**
         * The work that makes a model of a document.
         *
         * @param name the model's name
         * @param text the document's text
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the document as it is; null for the axis that the document names
         * @param scaling as for Model's constructor
         */
        public static function of(name:String, text:String, upAxis:Object, scaling:String):ModelBuilder
        {
            var data:ModelData = ModelData.forFile(name, upAxis == null ? "z" : upAxis, scaling);
            return new ModelBuilder(data, new ColladaReader(data, text, upAxis != null));
        }

        private function readingDocument(root:ColladaElement, isAxisNamed:Boolean):Steps
        {
            refuseIf(root == null, _data.name, "this is not XML: expected a COLLADA document");
            root.refuseIf(root.name != "COLLADA", "expected a COLLADA document, but its root element is <" + root.name + ">");
            var asset:ColladaElement = root.child("asset");
            _data.upAxis = isAxisNamed ? _data.upAxis : upAxisOf(asset);
            if (_data.scaling == Model.AS_GIVEN && _data.transform == ModelTransform.IDENTITY)
            {
                _data.transform = toMetres(asset);
            }
            var scene:ColladaScene = new ColladaScene(root);
            return new StepSequence().add(scene).begin(function():Steps
                {
                    return readingInstances(scene.instances);
                });
        }

        private function readingInstances(instances:Vector.<ColladaInstance>):Steps
        {
            // points without a surface
            var loosePoints:Vector.<Number> = new Vector.<Number>();
            return new StepSequence().beginEach(instances.length, function(index:int):Steps
                {
                    var mesh:ColladaMesh = instances[index].mesh;
                    return new StepSequence().add(mesh).begin(function():Steps
                        {
                            _data.readShare = (index + 1) / instances.length;
                            return placing(instances[index], mesh.triangles.length > 0 ? _data.vertices : loosePoints);
                        });
                }).call(function():void
                {
                    _data.takeLoosePoints(loosePoints, "a scene or a library with a geometry in it");
                });
        }

        // The work that adds a mesh at an instance's place. If the instance's transform mirrors, the triangles' corner order is reversed.
        private function placing(instance:ColladaInstance, out:Vector.<Number>):Steps
        {
            var mesh:ColladaMesh = instance.mesh;
            var firstVertex:int = out.length / 3;
            var firstCorner:int = _data.triangles.length;
            var vertexCount:int = mesh.vertices.length / 3;
            var triangleCount:int = mesh.triangles.length / 3;
            instance.element.limits.requireMesh(firstVertex + vertexCount, firstCorner / 3 + triangleCount, instance.element);
            if (triangleCount > 0)
            {
                addLabels(instance, firstCorner / 3);
            }
            return new StepSequence().slices(vertexCount, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    var areFinite:Boolean = instance.transform.transformPoints(mesh.vertices, first, end, out, firstVertex + first);
                    refuseIf(!areFinite, _data.name, "its transformed coordinates are too large: they are not finite numbers", instance.element);
                }).slices(triangleCount, TRIANGLES_PER_STEP, function(first:int, end:int):void
                {
                    addTriangles(mesh.triangles, 3 * first, 3 * end, firstVertex, firstCorner, instance.transform.isMirror);
                });
        }

        // An instance is a mesh with the name of its node. Its materials are those that it binds to the symbols of its geometry.
        private function addLabels(instance:ColladaInstance, firstTriangle:int):void
        {
            var element:ColladaElement = instance.element;
            var label:String = nameOf(element.name != "geometry" && element.parent != null ? element.parent : element) || nameOf(instance.mesh.geometry);
            element.limits.countElements(instance.mesh.symbols.length, element);
            _data.meshes.beginRun(_data.meshes.addName(label), firstTriangle);
            for (var i:int = 0; i < instance.mesh.symbols.length; i++)
            {
                _data.materials.beginRun(numberOf(instance.mesh.symbols[i], element), firstTriangle + instance.mesh.starts[i]);
            }
        }

        // The number of the material that an instance of a geometry binds to a symbol. A symbol that is not bound counts as a material. -1 for no symbol.
        private function numberOf(symbol:String, instance:ColladaElement):int
        {
            if (symbol == "")
            {
                return -1;
            }
            var material:ColladaElement = materialOf(symbol, instance);
            // A symbol may be equal to another material's id.
            return material == null ? _data.materials.addKey("symbol " + symbol, symbol) : _data.materials.addKey("material " + material.id, nameOf(material));
        }

        // The material that an instance of a geometry binds to a symbol; null if it binds none, or one that is not in this file.
        private static function materialOf(symbol:String, instance:ColladaElement):ColladaElement
        {
            var binding:ColladaElement = instance.child("bind_material");
            var technique:ColladaElement = binding == null ? null : binding.child("technique_common");
            var bound:ColladaElement = technique == null ? null : technique.child("instance_material", symbol);
            return bound == null ? null : instance.elementsById["material" + bound.attribute("target")];
        }

        private static function nameOf(element:ColladaElement):String
        {
            return element.attribute("name") || element.id || null;
        }

        private function addTriangles(from:Vector.<uint>, first:int, last:int, firstVertex:int, firstCorner:int, isMirror:Boolean):void
        {
            var to:Vector.<uint> = _data.triangles;
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

        // Scales by the document's unit. A unit that is no length counts as a metre.
        private static function toMetres(asset:ColladaElement):ModelTransform
        {
            var element:ColladaElement = asset == null ? null : asset.child("unit");
            var unit:Number = element == null ? 1 : Decimal.of(TextWords.of(element.attribute("meter")).join(" "));
            unit = unit > 0 && unit < Infinity ? unit : 1;
            return new ModelTransform(null, new Vector3D(unit, unit, unit));
        }

        private function upAxisOf(asset:ColladaElement):String
        {
            var element:ColladaElement = asset == null ? null : asset.child("up_axis");
            if (element == null)
            {
                return "y";
            }
            var axis:String = TextWords.of(element.text).join(" ");
            refuseIf(!/^[XYZ]_UP$/.test(axis), _data.name, "expected X_UP, Y_UP or Z_UP, but found \"" + shortened(axis) + "\"", element);
            return axis.charAt(0).toLowerCase();
        }
    }
}
