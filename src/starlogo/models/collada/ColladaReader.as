package starlogo.models.collada
{
    import flash.geom.Vector3D;
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

    /**
     * Reads a COLLADA document. ColladaModel says which parts.
     *
     * <p>An XmlReader makes ColladaElements of the text. A ColladaScene finds the geometries and where nodes place them. Each geometry is
     * a ColladaMesh, whose points come from a ColladaSource and whose triangles from ColladaPrimitives. Each place is a ColladaInstance, which
     * adds the mesh to the model.</p>
     *
     * @private
     */
    public final class ColladaReader extends StepSequence
    {
        private var _data:ModelData;

        /**
         * @param data takes what is read
         * @param xml the document; its steps may be done
         * @param isAxisNamed whether the axis that points up in the data counts, instead of the one that the document names
         * @param pose moves the scene; null at rest
         */
        public function ColladaReader(data:ModelData, xml:XmlReader, isAxisNamed:Boolean, pose:ColladaPose = null)
        {
            _data = data;
            add(xml).begin(function():Steps
                {
                    return readingDocument(rootOf(data.name, xml), isAxisNamed, pose);
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
            var data:ModelData = dataFor(name, upAxis, scaling);
            return new ModelBuilder(data, new ColladaReader(data, xmlOf(data.name, text), upAxis != null));
        }

        /** The data of a model that is not read yet. The parameters are those of of(). */
        internal static function dataFor(name:String, upAxis:Object, scaling:String):ModelData
        {
            return ModelData.forFile(name, upAxis == null ? "z" : upAxis, scaling);
        }

        /** The steps that read the elements of a text. @param name the model's name */
        internal static function xmlOf(name:String, text:String):XmlReader
        {
            refuseIf(text == null, name, "there is no text to read");
            return new XmlReader(text, new FileLimits(name, text.length));
        }

        /** The root of a document, whose elements are read. @param name the model's name @throws ModelError if it is not COLLADA */
        internal static function rootOf(name:String, xml:XmlReader):ColladaElement
        {
            refuseIf(xml.root == null, name, "this is not XML: expected a COLLADA document");
            xml.root.refuseIf(xml.root.name != "COLLADA", "expected a COLLADA document, but its root element is <" + xml.root.name + ">");
            return xml.root;
        }

        private function readingDocument(root:ColladaElement, isAxisNamed:Boolean, pose:ColladaPose):Steps
        {
            var asset:ColladaElement = root.child("asset");
            _data.upAxis = isAxisNamed ? _data.upAxis : upAxisOf(asset);
            if (_data.scaling == Model.AS_GIVEN && _data.transform == null)
            {
                _data.transform = toMetres(asset);
            }
            var scene:ColladaScene = new ColladaScene(root, pose);
            return new StepSequence().add(scene).begin(function():Steps
                {
                    return readingInstances(scene.instances);
                });
        }

        private function readingInstances(instances:Vector.<ColladaInstance>):Steps
        {
            var loosePoints:Vector.<Number> = new Vector.<Number>();
            return new StepSequence().beginEach(instances.length, function(index:int):Steps
                {
                    _data.readShare = index / instances.length;
                    return instances[index].adding(_data, loosePoints);
                }).call(function():void
                {
                    _data.readShare = 1;
                    _data.takeLoosePoints(loosePoints, "a scene or a library with a geometry in it");
                });
        }

        // The transform that scales by the document's unit; null for metres. A unit that is no length counts as a metre.
        private static function toMetres(asset:ColladaElement):ModelTransform
        {
            var element:ColladaElement = asset == null ? null : asset.child("unit");
            var unit:Number = element == null ? 1 : Decimal.of(TextWords.of(element.attribute("meter")).join(" "));
            return unit > 0 && unit < Infinity && unit != 1 ? new ModelTransform(null, new Vector3D(unit, unit, unit)) : null;
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
