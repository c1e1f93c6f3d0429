package starlogo.models.gltf
{
    import starlogo.models.ModelLimits;
    import starlogo.models.ModelReader;
    import starlogo.models.UpAxis;
    import starlogo.models.VertexFilter;
    import starlogo.models.refuseIf;
    import starlogo.steps.Steps;

    /**
     * Reads a glTF file. GltfModel says which parts.
     *
     * @private
     */
    public final class GltfReader extends ModelReader
    {
        /** The most points for all meshes together. Several meshes may share one source; it counts for each. */
        private static const MAX_POINTS:int = 4000000;

        private var _file:GltfFile;
        private var _scene:GltfScene = null;

        // the node whose mesh is next, and the next primitive of that mesh
        private var _node:int = 0;
        private var _primitive:int = 0;
        private var _reading:Steps = null;

        // Results so far. The key of a mesh's vertices is their accessors. The key of the present node's vertices is everything they
        // depend on.
        private var _sources:Object = {};
        private var _placed:Object = {};
        private var _pointCount:Number = 0;

        /**
         * @param name the model's name
         * @param file the file; all its steps must be done and all buffers set
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the file as it is; null for y
         */
        public function GltfReader(name:String, file:GltfFile, upAxis:Object)
        {
            super(name, upAxis == null ? UpAxis.Y : UpAxis.of(upAxis, name));
            _file = file;
            begin(walking).repeat(readParts).begin(droppingUnused);
        }

        /** @inheritDoc */
        override public function get progress():Number
        {
            return _scene == null || _scene.nodes.length == 0 ? 0 : 0.9 * _node / _scene.nodes.length;
        }

        private function walking():Steps
        {
            _scene = new GltfScene(_file.json, UpAxis.transform(upAxis));
            return _scene;
        }

        private function readParts():Boolean
        {
            if (_reading == null || !_reading.step())
            {
                _reading = null;
                return nextPart();
            }
            return true;
        }

        // Begins the next reading of the present primitive, or goes on to the next primitive. Returns false if there are no more.
        private function nextPart():Boolean
        {
            if (_node == _scene.nodes.length)
            {
                return false;
            }
            var json:GltfJson = _file.json;
            var node:Object = json.entry("nodes", _scene.nodes[_node]);
            var mesh:int = json.reference(node, "mesh", "nodes[" + _scene.nodes[_node] + "]", "meshes");
            var primitives:Array = json.listIn(json.entry("meshes", mesh), "primitives", "meshes[" + mesh + "]");
            if (_primitive == primitives.length)
            {
                _primitive = 0;
                _node++;
                _placed = {};
                return true;
            }
            var where:String = "meshes[" + mesh + "].primitives";
            var primitive:Object = json.elementOf(primitives, _primitive, where);
            where += "[" + _primitive + "]";
            _file.refuseDraco(primitive, where);
            if (!beginReading(node, json.entry("meshes", mesh), mesh, primitive, where))
            {
                _primitive++;
            }
            return true;
        }

        // Whether a primitive needs more reading. The mesh's vertices come first, then the vertices at the node's place, then the
        // triangles.
        private function beginReading(node:Object, mesh:Object, meshIndex:int, primitive:Object, where:String):Boolean
        {
            var json:GltfJson = _file.json;
            var attributes:Object = json.objectIn(primitive, "attributes", where);
            var position:int = attributes == null ? -1 : json.reference(attributes, "POSITION", where + ".attributes", "accessors");
            if (position < 0)
            {
                return false; // the primitive has no vertices
            }
            var source:GltfAccessor = _sources["#" + position];
            if (source == null)
            {
                source = new GltfAccessor(_file, position, "VEC3", ModelLimits.VERTICES);
                countPoints(source.count, where);
                _sources["#" + position] = source;
                _reading = source;
                return true;
            }
            var weights:Vector.<Number> = json.numbers(mesh, "weights", "meshes[" + meshIndex + "]", -1, new Vector.<Number>());
            weights = json.numbers(node, "weights", "nodes[" + _scene.nodes[_node] + "]", -1, weights);
            var hasSurface:Boolean = GltfPart.modeOf(json, primitive, where) >= GltfPart.TRIANGLES;
            var targets:Array = json.listIn(primitive, "targets", where);
            // primitives may share their vertices and have different triangles
            var isPlain:Boolean = targets.length == 0 && attributes.JOINTS_0 === undefined;
            var key:String = "#" + position + hasSurface + (isPlain ? "" : "," + _primitive);
            var points:GltfPoints = _placed[key];
            if (points == null)
            {
                countPoints(source.count * (1 + GltfPoints.activeCount(targets, weights)), where);
                points = new GltfPoints(_file, _scene, _scene.nodes[_node], primitive, where, weights, source, hasSurface ? vertices : loosePoints);
                _placed[key] = points;
                _reading = points;
                return true;
            }
            _primitive++;
            _reading = hasSurface ? new GltfPart(_file, primitive, where, points, triangles) : null;
            return true;
        }

        private function countPoints(count:Number, where:String):void
        {
            _pointCount += count;
            refuseIf(_pointCount > MAX_POINTS, name, "the meshes up to this one together have more than " + MAX_POINTS + " points", where);
        }

        private function droppingUnused():Steps
        {
            takeVertices("a mesh in the scene");
            return triangles.length == 0 ? null : new VertexFilter(vertices, triangles, new Vector.<uint>(vertices.length / 3));
        }
    }
}
