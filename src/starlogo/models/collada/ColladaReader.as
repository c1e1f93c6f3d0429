package starlogo.models.collada
{
    import starlogo.models.ModelReader;
    import starlogo.models.TextTokens;
    import starlogo.models.UpAxis;
    import starlogo.models.refuseIf;
    import starlogo.steps.Steps;

    /**
     * Reads a COLLADA document; ColladaModel says what of it.
     *
     * @private
     */
    public final class ColladaReader extends ModelReader
    {
        private var _source:String;
        private var _upAxis:String;
        private var _document:ColladaDocument = null;
        private var _scene:ColladaScene = null;
        private var _instance:int = 0;
        private var _meshes:Object = {};

        // the mesh of the instance that is next, if it is read already or being read, and the work on it
        private var _mesh:ColladaMesh = null;
        private var _reading:Steps = null;

        // the points of geometries without surfaces: of use only where no geometry has any
        private var _loosePoints:Vector.<Number> = new Vector.<Number>();

        /**
         * @param name the model's name
         * @param source the document's text
         * @param upAxis "x", "y" or "z", or a ModelTransform, for which the document is left as it is; null for what it says
         */
        public function ColladaReader(name:String, source:String, upAxis:Object)
        {
            super(name);
            _source = source;
            _upAxis = upAxis == null ? null : UpAxis.of(upAxis, name);
            begin(measuring).call(parse).begin(walking).repeat(readInstances).begin(turningUp);
        }

        /** @inheritDoc */
        override public function get progress():Number
        {
            return _instance == 0 ? 0 : 0.9 * _instance / _scene.instances.length;
        }

        private function measuring():Steps
        {
            return _source == null ? null : new XmlMeter(name, _source);
        }

        private function parse():void
        {
            _document = new ColladaDocument(name, _source);
            _source = null;
        }

        private function walking():Steps
        {
            _scene = new ColladaScene(_document);
            return _scene;
        }

        private function readInstances():Boolean
        {
            if (_reading == null || !_reading.step())
            {
                _reading = nextReading();
            }
            return _reading != null;
        }

        // Of each instance the mesh, then its place; null when there are no more.
        private function nextReading():Steps
        {
            if (_instance == _scene.instances.length)
            {
                return null;
            }
            var instance:ColladaInstance = _scene.instances[_instance];
            var mesh:ColladaMesh = _mesh;
            if (mesh == null)
            {
                _mesh = meshOf(instance.geometry);
                return _mesh;
            }
            _mesh = null;
            _instance++;
            return new ColladaPlacing(_document, mesh, instance, mesh.hasSurfaces ? vertices : _loosePoints, triangles);
        }

        /** A geometry is read once, however often it is in the scene. */
        private function meshOf(geometry:ColladaElement):ColladaMesh
        {
            var key:String = "#" + geometry.id; // an id may be the name of a property that each Object has
            if (key == "#" || _meshes[key] == null)
            {
                _meshes[key] = new ColladaMesh(_document, geometry);
            }
            return _meshes[key];
        }

        private function turningUp():Steps
        {
            if (vertices.length == 0)
            {
                vertices = _loosePoints;
            }
            refuseIf(vertices.length == 0, name, "no vertices: expected a scene or a library with a geometry in it");
            return UpAxis.turning(vertices, _upAxis || upAxisOfDocument());
        }

        private function upAxisOfDocument():String
        {
            var asset:ColladaElement = _document.root.child("asset");
            var element:ColladaElement = asset == null ? null : asset.child("up_axis");
            if (element == null)
            {
                return UpAxis.Y;
            }
            var text:String = element.words.join(" ");
            _document.refuseIf(!/^[XYZ]_UP$/.test(text), element, "expected X_UP, Y_UP or Z_UP, but found \"" + TextTokens.shorten(text) +
                    "\"");
            return text.charAt(0).toLowerCase();
        }
    }
}
