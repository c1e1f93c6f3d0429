package starlogo.models.gltf
{
    import starlogo.geometry.AffineTransform;
    import starlogo.steps.StepSequence;

    /**
     * Adds the vertices of a primitive to a model, at the place of a node, in steps. They are morphed, and moved by their skin, at rest or in a
     * pose.
     */
    internal final class GltfVertices extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 4000;
        private static const SKINNED_PER_STEP:int = 1000;

        /** The index in the model of the first vertex. */
        public var firstVertex:int;

        /** The number of vertices that the steps add. */
        public var count:int;

        private var _node:GltfJson;
        private var _rest:GltfAccessor;
        private var _out:Vector.<Number>;
        // the points before the node places them
        private var _deformed:Vector.<Number>;
        // What moves the points: the joints of a skin, or the transform of the node.
        private var _jointMatrices:Vector.<AffineTransform> = null;
        private var _transform:AffineTransform;

        /**
         * @param file the file
         * @param scene knows the nodes' transforms
         * @param node the index of the node that has the primitive
         * @param primitive the primitive, which has positions
         * @param vertices takes its vertices
         */
        public function GltfVertices(file:GltfFile, scene:GltfScene, node:int, primitive:GltfJson, vertices:Vector.<Number>)
        {
            var attributes:GltfJson = primitive.object("attributes");
            _node = file.json.rootEntry("nodes", node);
            _rest = file.accessor(attributes.indexOrNone("POSITION", "accessors"), "VEC3");
            _out = vertices;
            firstVertex = vertices.length / 3;
            count = _rest.count;
            file.budget.checkMeshSize(firstVertex + Number(count), 0, primitive.place);
            add(_rest).call(function():void
                {
                    // other nodes may have the same mesh
                    _deformed = _rest.numbers.slice();
                });
            addMorphTargets(file, primitive, scene.weightsOf(node));
            var skin:int = _node.indexOrNone("skin", "skins");
            var isSkinned:Boolean = skin >= 0 && attributes.has("JOINTS_0");
            if (isSkinned)
            {
                var matrices:GltfAccessor = scene.inverseBindMatricesOf(skin);
                if (matrices != null)
                {
                    add(matrices);
                }
                var read:GltfSkinWeights = file.skinWeights(attributes, count, skin);
                add(read).call(function():void
                    {
                        _jointMatrices = scene.jointMatricesOf(skin);
                        file.budget.spendNumbers(read.influences.joints.length, attributes.place);
                    }).slices(count, SKINNED_PER_STEP, function(first:int, end:int):void
                    {
                        read.influences.skinPoints(_deformed, _jointMatrices, first, end);
                    });
            }
            _transform = isSkinned ? new AffineTransform() : scene.globalTransformOf(node);
            slices(count, VERTICES_PER_STEP, transformVertices);
        }

        /** Whether the node mirrors, or the first joint of its skin. Read it when no step is left. */
        public function get isMirror():Boolean
        {
            return (_jointMatrices == null ? _transform : _jointMatrices[0]).isMirror;
        }

        private function addMorphTargets(file:GltfFile, primitive:GltfJson, weights:Vector.<Number>):void
        {
            var targetCount:int = primitive.count("targets");
            for (var i:int = 0; i < targetCount && i < weights.length; i++)
            {
                var index:int = primitive.element("targets", i).indexOrNone("POSITION", "accessors");
                if (index >= 0 && weights[i] != 0)
                {
                    addMorphTarget(file.accessor(index, "VEC3"), weights[i]);
                    file.budget.spendNumbers(3 * Number(count), primitive.place);
                }
            }
        }

        private function addMorphTarget(target:GltfAccessor, weight:Number):void
        {
            target.requireCount(count);
            add(target).slices(3 * count, 3 * VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        _deformed[i] += weight * target.numbers[i];
                    }
                });
        }

        private function transformVertices(first:int, end:int):void
        {
            if (!_transform.transformPoints(_deformed, first, end, _out, firstVertex + first))
            {
                throw _node.error("its vertices are not finite numbers, or are too large at the node's place (" + _rest.json.place + ")");
            }
        }
    }
}
