package starlogo.models.gltf
{
    import starlogo.models.animation.Pose;
    import starlogo.models.building.FormatReader;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.removingUnusedVertices;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads a glTF file. GltfModel says which parts.
     *
     * <p>A GltfFile has the JSON, whose objects are GltfJsons, and the buffers. A GltfScene finds the nodes with meshes, and where they are. For each
     * primitive of a mesh, GltfVertices add the vertices that its GltfAccessors say to the model, and the reader the triangles. The scene has the
     * joints of a skin, and GltfSkinWeights say how much vertices follow them.</p>
     *
     * @private
     */
    public final class GltfReader extends StepSequence implements FormatReader
    {
        private static const TRIANGLES_PER_STEP:int = 5000;

        // modes of primitives; those of points and lines are less
        private static const TRIANGLES:int = 4;
        private static const STRIP:int = 5;
        private static const FAN:int = 6;

        private var _data:ModelData;
        private var _file:GltfFile;
        private var _scene:GltfScene;

        /**
         * @param file the file; its steps may be done
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the file as it is; null for y
         * @param scaling as for Model's constructor; null if the vertices are not normalised
         * @param pose the pose, whose targets are what <code>GltfScene.targetOf()</code> returns; null at rest
         */
        public function GltfReader(file:GltfFile, upAxis:Object, scaling:String, pose:Pose = null)
        {
            _data = ModelData.forFile(file.budget.modelName, upAxis, scaling, "y");
            _file = file;
            add(file).begin(function():Steps
                {
                    _scene = new GltfScene(file, pose);
                    return _scene;
                }).begin(readingNodes).call(endReading).add(removingUnusedVertices(_data.vertices, _data.triangles));
        }

        /** @inheritDoc */
        public function get data():ModelData
        {
            return _data;
        }

        private function readingNodes():Steps
        {
            var json:GltfJson = _file.json;
            for (var i:int = 0; i < json.count("materials"); i++)
            {
                _data.materials.addLabel(json.rootEntry("materials", i).textOrNull("name"));
            }
            return new StepSequence().beginEach(_scene.nodes.length, readingNode);
        }

        // The work on the mesh of one of the scene's nodes.
        private function readingNode(index:int):Steps
        {
            var nodeIndex:int = _scene.nodes[index];
            var node:GltfJson = _file.json.rootEntry("nodes", nodeIndex);
            var mesh:GltfJson = node.rootEntry("meshes", node.indexOrNone("mesh", "meshes"));
            var name:String = node.textOrNull("name") || mesh.textOrNull("name");
            // The vertices of this node so far, by what they depend on beside the node and its skin.
            var placed:Object = {};
            _data.readProgress = index / _scene.nodes.length;
            // each primitive may have a target for each weight
            _file.budget.spendElements((1 + _scene.weightsOf(nodeIndex).length) * (1 + mesh.count("primitives")), mesh.place);
            return new StepSequence().beginEach(mesh.count("primitives"), function(primitive:int):Steps
                {
                    return readingPrimitive(nodeIndex, name, mesh.element("primitives", primitive), placed);
                });
        }

        // The steps that read a primitive of a node's mesh: its vertices, where the node puts them, and its triangles, which all have one material.
        // No steps if it has no vertices.
        private function readingPrimitive(node:int, name:String, primitive:GltfJson, placed:Object):Steps
        {
            var work:StepSequence = new StepSequence();
            primitive.refuseIf(primitive.hasExtension(GltfFile.DRACO), "it is " + GltfFile.DRACO_PROBLEM);
            var attributes:GltfJson = primitive.object("attributes");
            var position:int = attributes == null ? -1 : attributes.indexOrNone("POSITION", "accessors");
            if (position < 0)
            {
                return work;
            }
            // primitives may share their vertices and have different triangles
            var isPlain:Boolean = primitive.count("targets") == 0 && !attributes.has("JOINTS_0");
            var key:String = position + (isPlain ? "" : primitive.place);
            var points:GltfVertices = placed[key] ||= new GltfVertices(_file, _scene, node, primitive, _data.vertices);
            work.add(points);
            var mode:int = primitive.integer("mode", FAN, TRIANGLES);
            if (mode >= TRIANGLES)
            {
                _data.meshes.beginRun(_data.meshes.labelWithKey(String(node), name), _data.triangles.length / 3);
                _data.materials.beginRun(primitive.indexOrNone("material", "materials"), _data.triangles.length / 3);
                addTriangles(work, mode, primitive, points);
            }
            return work;
        }

        // Adds the steps that read a primitive's triangles, after those of its vertices. Triangle n of a list has the corners 3n, 3n+1 and 3n+2.
        // Triangle n of a fan has the corners n+1, n+2 and 0. In a strip, every second triangle has its corner order reversed.
        private function addTriangles(work:StepSequence, mode:int, primitive:GltfJson, vertices:GltfVertices):void
        {
            var index:int = primitive.indexOrNone("indices", "accessors");
            var indices:GltfAccessor = index < 0 ? null : _file.accessor(index, "SCALAR");
            if (indices != null)
            {
                indices.json.refuseIf(!indices.areIndices, "indices must be 5121, 5123 or 5125, and not normalized", "componentType");
                work.add(indices);
            }
            var cornerCount:int = indices == null ? vertices.count : indices.count;
            var triangleCount:int = mode == TRIANGLES ? cornerCount / 3 : Math.max(0, cornerCount - 2);
            _file.budget.checkMeshSize(0, _data.triangles.length / 3 + triangleCount, primitive.place);
            work.slices(triangleCount, TRIANGLES_PER_STEP, function(first:int, end:int):void
                {
                    var isMirror:Boolean = vertices.isMirror;
                    for (var i:int = first; i < end; i++)
                    {
                        var a:int = mode == TRIANGLES ? 3 * i : (mode == FAN ? i + 1 : i);
                        var b:int = a + 1;
                        var c:int = mode == FAN ? 0 : a + 2;
                        var isReversed:Boolean = isMirror != (mode == STRIP && (i & 1) == 1);
                        _data.triangles.push(vertexAt(a, indices, vertices, primitive), vertexAt(isReversed ? c : b, indices, vertices, primitive),
                                vertexAt(isReversed ? b : c, indices, vertices, primitive));
                    }
                });
        }

        private static function vertexAt(corner:int, indices:GltfAccessor, vertices:GltfVertices, primitive:GltfJson):uint
        {
            var index:Number = indices == null ? corner : indices.numbers[corner];
            if (index >= vertices.count)
            {
                throw indices.json.error("element " + corner + " names vertex " + index + ": " + primitive.place + " has " + vertices.count);
            }
            return vertices.firstVertex + int(index);
        }

        private function endReading():void
        {
            _data.readProgress = 1;
            refuseModelIf(_data.vertices.length == 0, _data.name, "no vertices: expected a mesh in the scene");
        }
    }
}
