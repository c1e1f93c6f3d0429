package starlogo.models.collada
{
    import flash.geom.Vector3D;
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
     * a ColladaMesh, whose points come from a ColladaSource and whose triangles from ColladaPrimitives. Each place of a geometry is a
     * ColladaInstance, which adds the mesh to the model. A ColladaDeformation moves points by morphs and by ColladaSkins with
     * ColladaSkeletons, before.</p>
     *
     * <p>A ColladaAnimation moves the scene by ColladaChannels, which have the numbers of ColladaSamplers.</p>
     *
     * @private
     */
    public final class ColladaReader extends StepSequence
    {
        private var _data:ModelData;
        private var _scene:ColladaScene;

        /**
         * @param data takes what is read
         * @param document the document; its steps may be done
         * @param isAxisNamed whether the axis that points up in the data counts, instead of the one that the document names
         * @param animation moves the scene; null at rest
         * @param time the time of the animation, in the document's time, in seconds
         */
        public function ColladaReader(data:ModelData, document:ColladaDocument, isAxisNamed:Boolean, animation:ColladaAnimation = null, time:Number = 0)
        {
            _data = data;
            add(document.xml).begin(function():Steps
                {
                    readAsset(document.root.child("asset"), isAxisNamed);
                    _scene = new ColladaScene(document, animation, time);
                    return _scene;
                }).begin(readingInstances);
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
            return new ModelBuilder(data, new ColladaReader(data, new ColladaDocument(data.name, text), upAxis != null));
        }

        /** Reads the vertices at a time of an animation. They are not normalised. The parameters are those of of() and of the constructor. */
        internal static function verticesAt(document:ColladaDocument, upAxis:Object, animation:ColladaAnimation, time:Number):Vector.<Number>
        {
            var data:ModelData = dataFor(document.limits.modelName, upAxis, null);
            document.limits.restart();
            return data.verticesBy(new ColladaReader(data, document, upAxis != null, animation, time));
        }

        private static function dataFor(name:String, upAxis:Object, scaling:String):ModelData
        {
            return ModelData.forFile(name, upAxis == null ? "z" : upAxis, scaling);
        }

        private function readAsset(asset:ColladaElement, isAxisNamed:Boolean):void
        {
            _data.upAxis = isAxisNamed ? _data.upAxis : upAxisOf(asset);
            if (_data.scaling == Model.AS_GIVEN && _data.transform == null)
            {
                _data.transform = toMetres(asset);
            }
        }

        private function readingInstances():Steps
        {
            var instances:Vector.<ColladaInstance> = _scene.instances;
            var loosePoints:Vector.<Number> = new Vector.<Number>();
            // all geometries come first, so skins only have what these leave of the limits
            return new StepSequence().beginEach(instances.length, function(index:int):Steps
                {
                    _data.readShare = index / instances.length / 2;
                    return instances[index].mesh;
                }).beginEach(instances.length, function(index:int):Steps
                {
                    _data.readShare = (1 + index / instances.length) / 2;
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
