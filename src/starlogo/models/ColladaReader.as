package starlogo.models
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Reads a COLLADA document; ColladaModel says what of it. */
    internal final class ColladaReader implements ModelReader
    {
        private var _name:String;
        private var _source:String;
        private var _document:ColladaDocument = null;
        private var _scene:ColladaScene = null;
        private var _instance:int = 0;
        private var _meshes:Object = {};
        private var _mesh:ColladaMesh = null;
        private var _placing:ColladaPlacing = null;
        private var _isDone:Boolean = false;
        private var _work:StepSequence = new StepSequence().begin(measure).call(parse).begin(newScene).repeat(readInstances).begin(turnUp)
            .call(conclude);

        private var _vertices:Vector.<Number> = new Vector.<Number>();
        private var _triangles:Vector.<uint> = new Vector.<uint>();
        // the points of geometries without surfaces: of use only where no geometry has any
        private var _loosePoints:Vector.<Number> = new Vector.<Number>();

        /**
         * @param name the model's name
         * @param source the document's text
         */
        public function ColladaReader(name:String, source:String)
        {
            _name = name;
            _source = source;
        }

        /** @inheritDoc */
        public function get vertices():Vector.<Number>
        {
            return _vertices;
        }

        /** @inheritDoc */
        public function get triangles():Vector.<uint>
        {
            return _triangles;
        }

        /** @inheritDoc */
        public function get progress():Number
        {
            if (_isDone)
            {
                return 1;
            }
            return _instance == 0 ? 0 : 0.9 * _instance / _scene.instances.length;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            return _work.step();
        }

        private function measure():Steps
        {
            return _source == null ? null : new XmlMeter(_name, _source);
        }

        private function parse():void
        {
            _document = new ColladaDocument(_name, _source);
        }

        private function newScene():Steps
        {
            _scene = new ColladaScene(_document);
            return _scene;
        }

        private function readInstances():Boolean
        {
            if (_instance == _scene.instances.length)
            {
                return false;
            }
            var instance:ColladaInstance = _scene.instances[_instance];
            if (_mesh == null)
            {
                _mesh = meshOf(instance.geometry);
            }
            else if (_placing != null)
            {
                place();
            }
            else if (!_mesh.step())
            {
                _placing = new ColladaPlacing(_document, _mesh, instance, _mesh.hasSurfaces ? _vertices : _loosePoints, _triangles);
            }
            return true;
        }

        /** A geometry is read once, however often the scene has it. */
        private function meshOf(geometry:ColladaElement):ColladaMesh
        {
            var key:String = "#" + geometry.id; // an id may be the name of a property that each Object has
            if (key == "#" || _meshes[key] == null)
            {
                _meshes[key] = new ColladaMesh(_document, geometry);
            }
            return _meshes[key];
        }

        private function place():void
        {
            if (!_placing.step())
            {
                _placing = null;
                _mesh = null;
                _instance++;
            }
        }

        private function turnUp():Steps
        {
            if (_vertices.length == 0)
            {
                _vertices = _loosePoints;
            }
            if (_vertices.length == 0)
            {
                throw new ModelError(_name, "", "no vertices: expected a scene or a library with a geometry in it");
            }
            return UpAxis.turning(_vertices, upAxis());
        }

        private function conclude():void
        {
            _source = null;
            _document = null;
            _isDone = true;
        }

        private function upAxis():String
        {
            var asset:ColladaElement = _document.root.child("asset");
            var element:ColladaElement = asset == null ? null : asset.child("up_axis");
            if (element == null)
            {
                return UpAxis.Y;
            }
            var text:String = element.words.join(" ");
            switch (text)
            {
                case "X_UP":
                    return UpAxis.X;
                case "Y_UP":
                    return UpAxis.Y;
                case "Z_UP":
                    return UpAxis.Z;
                default:
                    throw _document.error(element, "expected X_UP, Y_UP or Z_UP, but found \"" +
                            TextTokens.shorten(text) + "\"");
            }
        }
    }
}
