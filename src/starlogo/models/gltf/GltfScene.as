package starlogo.models.gltf
{
    import starlogo.geometry.AffineTransform;
    import starlogo.geometry.Placement;
    import starlogo.models.animation.normaliseQuaternion;
    import starlogo.models.scene.DeformedPoints;
    import starlogo.models.scene.MeshInstance;
    import starlogo.models.scene.Scene;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * The scene of a glTF file. GltfModel says which parts are read.
     *
     * <p>A GltfFile has the JSON, whose objects are GltfJsons, and the buffers. The steps make the scene's nodes, and an instance of a GltfMesh at each node with
     * a mesh. A GltfMesh has the numbers of GltfAccessors.</p>
     *
     * @private
     */
    public final class GltfScene extends Scene
    {
        private static const NODES_PER_STEP:int = 200;

        private var _file:GltfFile;
        private var _meshes:Object = {}; // by the indices of the mesh and of a skin

        /**
         * @param file the file; its steps may be done
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the file as it is; null for y
         * @param scaling as for Model's constructor; null if the vertices are not normalised
         */
        public function GltfScene(file:GltfFile, upAxis:Object, scaling:String)
        {
            super(file.budget, upAxis, scaling);
            _file = file;
            add(file).begin(readingNodes).begin(visitingNodes);
        }

        /** The target of an animation that moves a property of a node. @param path "translation", "rotation", "scale" or "weights" */
        internal static function targetOf(node:int, path:String):String
        {
            return node + " " + path;
        }

        private function readingNodes():Steps
        {
            var count:int = _file.json.count("nodes");
            for (var i:int = 0; i < _file.json.count("materials"); i++)
            {
                data.materials.addLabel(_file.json.rootEntry("materials", i).textOrNull("name"));
            }
            for (i = 0; i < count; i++)
            {
                addNode(-1);
            }
            return new StepSequence().slices(count, NODES_PER_STEP, findParents);
        }

        private function findParents(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var node:GltfJson = _file.json.rootEntry("nodes", i);
                var count:int = node.count("children");
                for (var k:int = 0; k < count; k++)
                {
                    var child:int = node.indexIn("children", k, "nodes");
                    node.refuseIf(parents[child] >= 0 || child == i, "nodes[" + child + "] contains itself or has two parents", "children[" + k + "]");
                    parents[child] = i;
                }
            }
        }

        /** @inheritDoc */
        override protected function transformIn(index:int, around:AffineTransform):AffineTransform
        {
            var node:GltfJson = _file.json.rootEntry("nodes", index);
            var m:Vector.<Number> = node.numbers("matrix", 16);
            if (m != null)
            {
                node.refuseIf(m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1, "expected 0, 0, 0 and 1 as every fourth number", "matrix");
                return around.after(transformOfColumns(m, 0));
            }
            var t:Vector.<Number> = posedNumbers(index, "translation") || node.numbers("translation", 3, new <Number>[0, 0, 0]);
            var r:Vector.<Number> = posedNumbers(index, "rotation") || node.numbers("rotation", 4, new <Number>[0, 0, 0, 1]);
            var s:Vector.<Number> = posedNumbers(index, "scale") || node.numbers("scale", 3, new <Number>[1, 1, 1]);
            normaliseQuaternion(r);
            var rotation:Placement = new Placement();
            rotation.setQuaternion(r[0], r[1], r[2], r[3]);
            return around.after(AffineTransform.of(rotation, s[0], s[1], s[2], t[0], t[1], t[2]));
        }

        // The numbers of a node's property in the present pose; null if they are those in the file.
        private function posedNumbers(node:int, path:String):Vector.<Number>
        {
            return posed(targetOf(node, path));
        }

        /** The transform with 16 numbers, column by column. @param at the index of the first one */
        internal static function transformOfColumns(m:Vector.<Number>, at:int):AffineTransform
        {
            return new AffineTransform(new <Number>[
                        m[at], m[at + 4], m[at + 8], m[at + 12],
                        m[at + 1], m[at + 5], m[at + 9], m[at + 13],
                        m[at + 2], m[at + 6], m[at + 10], m[at + 14]]);
        }

        // The steps that walk through the scene that the file shows.
        private function visitingNodes():Steps
        {
            var pending:Vector.<int> = roots().reverse();
            var isVisited:Vector.<Boolean> = new Vector.<Boolean>(parents.length);
            return new StepSequence().repeat(function():Boolean
                {
                    for (var i:int = 0; i < NODES_PER_STEP && pending.length > 0; i++)
                    {
                        var node:int = pending.pop();
                        if (!isVisited[node])
                        {
                            isVisited[node] = true;
                            visit(node, pending);
                        }
                    }
                    return pending.length > 0;
                });
        }

        // The roots of the scene. If the file names none, those of all scenes. If there are no scenes, all nodes that are in no other node.
        private function roots():Vector.<int>
        {
            var roots:Vector.<int> = new Vector.<int>();
            var shown:int = _file.json.indexOrNone("scene", "scenes");
            var sceneCount:int = _file.json.count("scenes");
            for (var index:int = Math.max(shown, 0); index < (shown < 0 ? sceneCount : shown + 1); index++)
            {
                var sceneJson:GltfJson = _file.json.rootEntry("scenes", index);
                for (var i:int = 0; i < sceneJson.count("nodes"); i++)
                {
                    roots.push(sceneJson.indexIn("nodes", i, "nodes"));
                }
            }
            for (i = 0; i < parents.length && sceneCount == 0; i++)
            {
                if (parents[i] < 0)
                {
                    roots.push(i);
                }
            }
            return roots;
        }

        // Adds the instance of a node's mesh, if it has one. Its children are visited next.
        private function visit(index:int, pending:Vector.<int>):void
        {
            var node:GltfJson = _file.json.rootEntry("nodes", index);
            if (node.has("mesh"))
            {
                addInstance(index, node);
            }
            for (var k:int = node.count("children") - 1; k >= 0; k--)
            {
                pending.push(node.indexIn("children", k, "nodes"));
            }
        }

        private function addInstance(index:int, node:GltfJson):void
        {
            var meshIndex:int = node.indexOrNone("mesh", "meshes");
            var json:GltfJson = node.rootEntry("meshes", meshIndex);
            var skinIndex:int = node.indexOrNone("skin", "skins");
            var skin:GltfJson = skinIndex < 0 ? null : node.rootEntry("skins", skinIndex);
            _file.budget.spendElements(1 + json.count("primitives"), json.place);
            var scene:Scene = this;
            var mesh:GltfMesh = _meshes[meshIndex + " " + skinIndex] ||= new GltfMesh(_file, json, skin);
            var instance:MeshInstance = new MeshInstance(index, mesh, node.place, node.textOrNull("name") || json.textOrNull("name"));
            instance.deforming = !mesh.isDeformed ? null : function(deformed:DeformedPoints):Steps
            {
                return mesh.deforming(deformed, weightsOf(index, node, json), scene, index);
            };
            instances.push(instance);
        }

        // The weights of the morph targets of a node's mesh: those of the pose, otherwise of the node, otherwise of the mesh.
        private function weightsOf(index:int, node:GltfJson, mesh:GltfJson):Vector.<Number>
        {
            return posedNumbers(index, "weights") || node.numbers("weights", GltfJson.ANY_LENGTH) || mesh.numbers("weights", GltfJson.ANY_LENGTH, new Vector.<Number>());
        }
    }
}
