package starlogo.models.gltf
{
    import starlogo.geometry.AffineTransform;
    import starlogo.geometry.Placement;
    import starlogo.models.animation.Pose;
    import starlogo.models.animation.normaliseQuaternion;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** The scene of a glTF file, at rest or in a pose. Its steps find the nodes with meshes. */
    internal final class GltfScene extends StepSequence
    {
        private static const NODES_PER_STEP:int = 200;

        /** The indices of the nodes in the scene that have a mesh, when no step is left. */
        public var nodes:Vector.<int> = new Vector.<int>();

        private var _file:GltfFile;
        private var _pose:Pose;
        private var _parents:Vector.<int>;
        private var _globalTransforms:Vector.<AffineTransform>;
        private var _jointMatrices:Array = []; // lists of those so far, by the skin's index

        /**
         * @param file the file; all its steps must be done
         * @param pose the pose, whose targets are what <code>targetOf()</code> returns; null at rest
         */
        public function GltfScene(file:GltfFile, pose:Pose)
        {
            _file = file;
            _pose = pose;
            var count:int = file.json.count("nodes");
            _parents = new Vector.<int>(count);
            _globalTransforms = new Vector.<AffineTransform>(count);
            for (var i:int = 0; i < count; i++)
            {
                _parents[i] = -1;
            }
            slices(count, NODES_PER_STEP, findParents).begin(findingNodes);
        }

        /**
         * A node's transform in the scene: its own transform, and then the transforms of the nodes around it.
         *
         * @throws ModelError if a transform is wrong, or the node contains itself
         */
        public function globalTransformOf(node:int):AffineTransform
        {
            var chain:Vector.<int> = new Vector.<int>();
            for (var i:int = node; i >= 0 && _globalTransforms[i] == null; i = _parents[i])
            {
                _file.json.refuseIf(chain.length > _globalTransforms.length, "it contains itself", "nodes[" + node + "]");
                chain.push(i);
            }
            var transform:AffineTransform = i < 0 ? new AffineTransform() : _globalTransforms[i];
            while (chain.length > 0)
            {
                i = chain.pop();
                transform = transform.after(localTransformOf(i));
                _globalTransforms[i] = transform;
            }
            return transform;
        }

        /** The inverse bind matrices of a skin's joints; null if it has none. */
        public function inverseBindMatricesOf(skin:int):GltfAccessor
        {
            var json:GltfJson = _file.json.rootEntry("skins", skin);
            var count:int = json.count("joints");
            json.refuseIf(count == 0, "expected at least one joint", "joints");
            var index:int = json.indexOrNone("inverseBindMatrices", "accessors");
            var matrices:GltfAccessor = index < 0 ? null : _file.accessor(index, "MAT4");
            if (matrices != null)
            {
                matrices.json.refuseIf(matrices.count < count, "there are " + count + " joints, but fewer matrices");
            }
            return matrices;
        }

        /** What each joint of a skin does to points. It is the same for all that use the skin. Its matrices must be read. */
        public function jointMatricesOf(skin:int):Vector.<AffineTransform>
        {
            var json:GltfJson = _file.json.rootEntry("skins", skin);
            var matrices:GltfAccessor = inverseBindMatricesOf(skin);
            var known:Vector.<AffineTransform> = _jointMatrices[skin] ||= new Vector.<AffineTransform>();
            for (var i:int = known.length; i < json.count("joints"); i++)
            {
                var transform:AffineTransform = globalTransformOf(json.indexIn("joints", i, "nodes"));
                known.push(matrices == null ? transform : transform.after(ofColumns(matrices.numbers, 16 * i)));
            }
            return known;
        }

        /** The weights of the morph targets of a node's mesh: those of the pose, otherwise of the node, otherwise of the mesh. */
        public function weightsOf(index:int):Vector.<Number>
        {
            var node:GltfJson = _file.json.rootEntry("nodes", index);
            var mesh:GltfJson = node.rootEntry("meshes", node.indexOrNone("mesh", "meshes"));
            return posed(index, "weights") || node.numbers("weights", GltfJson.ANY_LENGTH) || mesh.numbers("weights", GltfJson.ANY_LENGTH, new Vector.<Number>());
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
                    node.refuseIf(_parents[child] >= 0 || child == i, "nodes[" + child + "] contains itself or has two parents", "children[" + k + "]");
                    _parents[child] = i;
                }
            }
        }

        // The steps that walk through the scene that the file shows.
        private function findingNodes():Steps
        {
            var pending:Vector.<int> = roots().reverse();
            var isVisited:Vector.<Boolean> = new Vector.<Boolean>(_parents.length);
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

        // Notes whether a node has a mesh. Its children are visited next.
        private function visit(node:int, pending:Vector.<int>):void
        {
            var entry:GltfJson = _file.json.rootEntry("nodes", node);
            if (entry.has("mesh"))
            {
                nodes.push(node);
            }
            for (var k:int = entry.count("children") - 1; k >= 0; k--)
            {
                pending.push(entry.indexIn("children", k, "nodes"));
            }
        }

        // The roots of the scene. If the file names none, those of all scenes. If there are no scenes, all nodes that are in no other node.
        private function roots():Vector.<int>
        {
            var roots:Vector.<int> = new Vector.<int>();
            var shown:int = _file.json.indexOrNone("scene", "scenes");
            var sceneCount:int = _file.json.count("scenes");
            for (var index:int = Math.max(shown, 0); index < (shown < 0 ? sceneCount : shown + 1); index++)
            {
                var scene:GltfJson = _file.json.rootEntry("scenes", index);
                for (var i:int = 0; i < scene.count("nodes"); i++)
                {
                    roots.push(scene.indexIn("nodes", i, "nodes"));
                }
            }
            for (i = 0; i < _parents.length && sceneCount == 0; i++)
            {
                if (_parents[i] < 0)
                {
                    roots.push(i);
                }
            }
            return roots;
        }

        private function localTransformOf(index:int):AffineTransform
        {
            var node:GltfJson = _file.json.rootEntry("nodes", index);
            var m:Vector.<Number> = node.numbers("matrix", 16);
            if (m != null)
            {
                node.refuseIf(m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1, "expected 0, 0, 0 and 1 as every fourth number", "matrix");
                return ofColumns(m, 0);
            }
            var t:Vector.<Number> = posed(index, "translation") || node.numbers("translation", 3, new <Number>[0, 0, 0]);
            var r:Vector.<Number> = posed(index, "rotation") || node.numbers("rotation", 4, new <Number>[0, 0, 0, 1]);
            var s:Vector.<Number> = posed(index, "scale") || node.numbers("scale", 3, new <Number>[1, 1, 1]);
            normaliseQuaternion(r);
            var rotation:Placement = new Placement();
            rotation.setQuaternion(r[0], r[1], r[2], r[3]);
            return AffineTransform.of(rotation, s[0], s[1], s[2], t[0], t[1], t[2]);
        }

        // The numbers of a node's property in the pose; null if they are those in the file.
        private function posed(node:int, path:String):Vector.<Number>
        {
            return _pose == null ? null : _pose.numbersOf(targetOf(node, path));
        }

        /** The target of an animation that moves a property of a node. @param path "translation", "rotation", "scale" or "weights" */
        internal static function targetOf(node:int, path:String):String
        {
            return node + " " + path;
        }

        // The transform with 16 numbers, column by column. @param at the index of the first one
        private static function ofColumns(m:Vector.<Number>, at:int):AffineTransform
        {
            return new AffineTransform(new <Number>[
                        m[at], m[at + 4], m[at + 8], m[at + 12],
                        m[at + 1], m[at + 5], m[at + 9], m[at + 13],
                        m[at + 2], m[at + 6], m[at + 10], m[at + 14]]);
        }
    }
}
