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

        /** Whether the node mirrors, or the first joint of its skin. Read it when no step is left. */
        public var isMirror:Boolean;

        // the points before the node places them
        private var _deformed:Vector.<Number>;

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
            var json:GltfJson = file.json.rootEntry("nodes", node);
            var rest:GltfAccessor = file.accessor(attributes.indexOrNone("POSITION", "accessors"), "VEC3");
            firstVertex = vertices.length / 3;
            count = rest.count;
            file.budget.checkMeshSize(firstVertex + Number(count), 0, primitive.place);
            add(rest).call(function():void
                {
                    // other nodes may have the same mesh
                    _deformed = rest.numbers.slice();
                });
            addMorphTargets(file, primitive, scene.weightsOf(node));
            var skin:int = json.indexOrNone("skin", "skins");
            var transform:AffineTransform = new AffineTransform();
            if (skin >= 0 && attributes.has("JOINTS_0"))
            {
                addSkin(file, scene, attributes, skin);
            }
            else
            {
                transform = scene.globalTransformOf(node);
                isMirror = transform.isMirror;
            }
            slices(count, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    if (!transform.transformPoints(_deformed, first, end, vertices, firstVertex + first))
                    {
                        throw json.error("its vertices are not finite numbers, or are too large at the node's place (" + rest.json.place + ")");
                    }
                });
        }

        private function addSkin(file:GltfFile, scene:GltfScene, attributes:GltfJson, skin:int):void
        {
            var matrices:GltfAccessor = scene.inverseBindMatricesOf(skin);
            var weights:GltfSkinWeights = file.skinWeights(attributes, count, skin);
            var jointMatrices:Vector.<AffineTransform>;
            if (matrices != null)
            {
                add(matrices);
            }
            add(weights).call(function():void
                {
                    jointMatrices = scene.jointMatricesOf(skin);
                    isMirror = jointMatrices[0].isMirror;
                    file.budget.spendNumbers(weights.influences.joints.length, attributes.place);
                }).slices(count, SKINNED_PER_STEP, function(first:int, end:int):void
                {
                    weights.influences.skinPoints(_deformed, jointMatrices, first, end);
                });
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
    }
}
