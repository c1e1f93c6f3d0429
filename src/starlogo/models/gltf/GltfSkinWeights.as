package starlogo.models.gltf
{
    import starlogo.models.animation.JointInfluences;
    import starlogo.steps.StepSequence;

    /** How much the vertices of a glTF primitive follow the joints of a skin. Its steps read it. All nodes and poses that have both share it. */
    internal final class GltfSkinWeights extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 2000;

        /** The influences, when no step is left. */
        public var influences:JointInfluences = new JointInfluences();

        /**
         * @param file the file
         * @param attributes the attributes of the primitive, with at least one set of joints
         * @param vertexCount the number of its vertices
         * @param jointCount the number of the skin's joints
         */
        public function GltfSkinWeights(file:GltfFile, attributes:GltfJson, vertexCount:int, jointCount:int)
        {
            // The accessors of sets: the indices of joints, and the weights of these. Each has four numbers for a vertex.
            var indices:Vector.<GltfAccessor> = new Vector.<GltfAccessor>();
            var weights:Vector.<GltfAccessor> = new Vector.<GltfAccessor>();
            for (var i:int = 0; attributes.has("JOINTS_" + i); i++)
            {
                indices.push(accessorOf(file, attributes, "JOINTS_" + i, vertexCount));
                weights.push(accessorOf(file, attributes, "WEIGHTS_" + i, vertexCount));
            }
            // sets may have the same accessors
            file.budget.spendNumbers(4 * Number(vertexCount) * i, attributes.place);
            slices(vertexCount, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    for (var vertex:int = first; vertex < end; vertex++)
                    {
                        for (var setIndex:int = 0; setIndex < indices.length; setIndex++)
                        {
                            readSet(indices[setIndex], weights[setIndex], vertex, jointCount);
                        }
                        influences.offsets.push(influences.joints.length);
                    }
                });
        }

        private function accessorOf(file:GltfFile, attributes:GltfJson, key:String, vertexCount:int):GltfAccessor
        {
            var index:int = attributes.indexOrNone(key, "accessors");
            attributes.refuseIf(index < 0, "a mesh has no weights for its joints");
            var found:GltfAccessor = file.accessor(index, "VEC4");
            found.requireCount(vertexCount);
            add(found);
            return found;
        }

        // Reads the influences of a vertex in a set. A weight of 0 is none, whatever its joint is.
        private function readSet(indices:GltfAccessor, weights:GltfAccessor, vertex:int, jointCount:int):void
        {
            for (var at:int = 4 * vertex; at < 4 * vertex + 4; at++)
            {
                var joint:Number = indices.numbers[at];
                if (weights.numbers[at] == 0)
                {
                    continue;
                }
                if (!(joint >= 0 && joint < jointCount && int(joint) == joint))
                {
                    throw indices.json.error("vertex " + vertex + " names joint " + joint + ", but there are only " + jointCount);
                }
                influences.joints.push(joint);
                influences.weights.push(weights.numbers[at]);
            }
        }
    }
}
