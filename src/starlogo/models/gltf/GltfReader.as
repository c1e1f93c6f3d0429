package starlogo.models.gltf
{
    import starlogo.models.FileLimits;
    import starlogo.models.ModelReader;
    import starlogo.models.VertexFilter;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads a glTF file. GltfModel says which parts.
     *
     * <p>A GltfFile has the JSON, whose objects are GltfJsons, and the buffers. A GltfScene finds the nodes with meshes, and where they are. For each
     * primitive of a mesh, GltfVertices and GltfTriangles add what its GltfAccessors say to the model.</p>
     *
     * @private
     */
    public final class GltfReader extends ModelReader
    {
        private var _file:GltfFile;
        private var _scene:GltfScene;

        /**
         * @param file the file; its steps may be done
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the file as it is; null for y
         * @param scaling as for Model's constructor
         * @param animation moves the scene. The vertices are not normalised then. If it is null, they are read at rest, and normalised
         * @param time the time of the animation, in seconds
         */
        public function GltfReader(file:GltfFile, upAxis:Object, scaling:String, animation:GltfAnimation = null, time:Number = 0)
        {
            super(file.limits.modelName, upAxis == null ? "y" : upAxis, scaling);
            _file = file;
            add(_file).begin(function():Steps
                {
                    return _scene = new GltfScene(_file, turnToZUp(), animation, time);
                }).begin(readingNodes).begin(droppingUnused);
            if (animation == null)
            {
                begin(normalising);
            }
        }

        private function readingNodes():Steps
        {
            var json:GltfJson = _file.json;
            for (var i:int = 0; i < json.count("materials"); i++)
            {
                data.materials.addName(json.fileEntry("materials", i).text("name"));
            }
            return new StepSequence().beginEach(_scene.nodes.length, readingNode);
        }

        // The work on the mesh of one of the scene's nodes.
        private function readingNode(index:int):Steps
        {
            var nodeIndex:int = _scene.nodes[index];
            var node:GltfJson = _file.json.fileEntry("nodes", nodeIndex);
            var mesh:GltfJson = node.fileEntry("meshes", node.reference("mesh", "meshes"));
            var weights:Vector.<Number> = _scene.animated(nodeIndex, "weights") || node.numbers("weights", -1)
                || mesh.numbers("weights", -1, new Vector.<Number>());
            var label:String = node.text("name") || mesh.text("name");
            // The vertices of this node so far. The key is everything that they depend on.
            var placed:Object = {};
            setReadShare(index / _scene.nodes.length);
            // each primitive may have a target for each weight
            _file.limits.count(FileLimits.THINGS, (1 + weights.length) * (1 + mesh.count("primitives")), mesh.place);
            return new StepSequence().beginEach(mesh.count("primitives"), function(primitive:int):Steps
                {
                    return readingPrimitive(nodeIndex, label, mesh.element("primitives", primitive), weights, placed);
                });
        }

        // The steps that read a primitive of a node's mesh: its vertices, where the node puts them, and its triangles, which all have one material.
        // No steps if it has no vertices.
        private function readingPrimitive(node:int, label:String, primitive:GltfJson, weights:Vector.<Number>, placed:Object):Steps
        {
            var work:StepSequence = new StepSequence();
            GltfFile.refuseDraco(primitive);
            var attributes:GltfJson = primitive.object("attributes");
            var position:int = attributes == null ? -1 : attributes.reference("POSITION", "accessors");
            if (position < 0)
            {
                return work;
            }
            var positions:GltfAccessor = _file.accessor(position, "VEC3");
            var hasSurface:Boolean = GltfTriangles.modeOf(primitive) >= GltfTriangles.TRIANGLES;
            // primitives may share their vertices and have different triangles
            var isPlain:Boolean = primitive.count("targets") == 0 && !attributes.has("JOINTS_0");
            var key:String = "#" + position + hasSurface + (isPlain ? "" : "," + primitive.place);
            var points:GltfVertices = placed[key] ||= new GltfVertices(_file, _scene, node, primitive, weights, positions, verticesFor(hasSurface));
            work.add(points);
            if (hasSurface)
            {
                data.meshes.beginRun(data.meshes.addKey(String(node), label), data.triangles.length / 3);
                data.materials.beginRun(primitive.reference("material", "materials"), data.triangles.length / 3);
                work.add(new GltfTriangles(_file, primitive, points, data.triangles));
            }
            return work;
        }

        private function droppingUnused():Steps
        {
            takeVertices("a mesh in the scene");
            return data.triangles.length == 0 ? null : new VertexFilter(data.vertices, data.triangles, new Vector.<uint>(data.vertices.length / 3));
        }
    }
}
