package starlogo.models.gltf
{
    import starlogo.models.ModelBudget;
    import starlogo.models.ModelReader;
    import starlogo.models.VertexFilter;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads a glTF file. GltfModel says which parts.
     *
     * @private
     */
    public final class GltfReader extends ModelReader
    {
        private var _file:GltfFile;
        private var _animated:Object;

        /**
         * @param name the model's name
         * @param file the file; all its steps must be done and all buffers set
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the file as it is; null for y
         * @param scaling as for Model's constructor
         * @param animated the values of a GltfAnimation at a time: the vertices are not normalised then; null for the rest pose
         */
        public function GltfReader(name:String, file:GltfFile, upAxis:Object, scaling:String, animated:Object = null)
        {
            super(name, upAxis == null ? "y" : upAxis, scaling);
            _file = file;
            _animated = animated;
            begin(readingScene).begin(droppingUnused);
            if (animated == null)
            {
                begin(normalising);
            }
        }

        private function readingScene():Steps
        {
            var json:GltfJson = _file.json;
            for (var i:int = 0; i < json.count("materials"); i++)
            {
                data.materials.addNumber(textOf(json.entry("materials", i).name));
            }
            var scene:GltfScene = new GltfScene(json, turnUp, _animated);
            var next:int = 0;
            return new StepSequence().add(scene).beginEach(function():Steps
                {
                    if (next == scene.nodes.length)
                    {
                        return null;
                    }
                    progress = 0.9 * next / scene.nodes.length;
                    return readingNode(scene, scene.nodes[next++]);
                });
        }

        // The work on the mesh of a node.
        private function readingNode(scene:GltfScene, nodeIndex:int):Steps
        {
            var json:GltfJson = _file.json;
            var node:Object = json.entry("nodes", nodeIndex);
            var index:int = json.reference(node, "mesh", "nodes[" + nodeIndex + "]", "meshes");
            var mesh:Object = json.entry("meshes", index);
            var place:String = "meshes[" + index + "]";
            var primitives:Array = json.listIn(mesh, "primitives", place);
            var weights:Vector.<Number> = GltfAnimation.valueIn(_animated, nodeIndex, "weights")
                || json.numbers(node, "weights", "nodes[" + nodeIndex + "]", -1) || json.numbers(mesh, "weights", place, -1, new Vector.<Number>());
            // The vertices of this node so far. The key is everything that they depend on.
            var placed:Object = {};
            var next:int = 0;
            return new StepSequence().beginEach(function():Steps
                {
                    _file.budget.take(ModelBudget.THINGS, 1 + weights.length, place);
                    if (next == primitives.length)
                    {
                        return null;
                    }
                    var primitive:Object = json.elementOf(primitives, next, place + ".primitives");
                    return readingPrimitive(scene, nodeIndex, primitive, place + ".primitives[" + next+++"]", weights, placed);
                });
        }

        // The work on a primitive: its vertices, the vertices at the node's place, the triangles. Nothing if it has no vertices.
        private function readingPrimitive(scene:GltfScene, node:int, primitive:Object, place:String, weights:Vector.<Number>, placed:Object):Steps
        {
            var json:GltfJson = _file.json;
            var work:StepSequence = new StepSequence();
            _file.refuseDraco(primitive, place);
            var attributes:Object = json.objectIn(primitive, "attributes", place);
            var position:int = attributes == null ? -1 : json.reference(attributes, "POSITION", place + ".attributes", "accessors");
            if (position < 0)
            {
                return work;
            }
            var positions:GltfAccessor = _file.accessor(position, "VEC3");
            var hasSurface:Boolean = GltfTriangles.modeOf(json, primitive, place) >= GltfTriangles.TRIANGLES;
            // primitives may share their vertices and have different triangles
            var isPlain:Boolean = json.listIn(primitive, "targets", place).length == 0 && attributes.JOINTS_0 === undefined;
            var key:String = "#" + position + hasSurface + (isPlain ? "" : "," + place);
            var points:GltfVertices = placed[key] ||= new GltfVertices(_file, scene, node, primitive, place, weights, positions,
                    verticesFor(hasSurface));
            work.add(points);
            if (hasSurface)
            {
                addLabels(node, primitive, place);
            }
            return hasSurface ? work.add(new GltfTriangles(_file, primitive, place, points, data.triangles)) : work;
        }

        // A node is a mesh with its name, or its mesh's. A primitive has one material.
        private function addLabels(node:int, primitive:Object, place:String):void
        {
            var json:GltfJson = _file.json;
            var entry:Object = json.entry("nodes", node);
            var mesh:Object = json.entry("meshes", json.reference(entry, "mesh", "nodes[" + node + "]", "meshes"));
            data.meshes.beginRun(data.meshes.numberFor(String(node), textOf(entry.name) || textOf(mesh.name)), data.triangles.length / 3);
            data.materials.beginRun(json.reference(primitive, "material", place, "materials"), data.triangles.length / 3);
        }

        private static function textOf(value:*):String
        {
            return value is String && value != "" ? value : null;
        }

        private function droppingUnused():Steps
        {
            takeVertices("a mesh in the scene");
            return data.triangles.length == 0 ? null : new VertexFilter(data.vertices, data.triangles, new Vector.<uint>(data.vertices.length / 3));
        }
    }
}
