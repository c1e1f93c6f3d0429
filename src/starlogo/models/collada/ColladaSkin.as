package starlogo.models.collada
{
    import starlogo.data.keyOf;
    import starlogo.geometry.AffineTransform;
    import starlogo.models.files.shortened;
    import starlogo.models.scene.JointInfluences;
    import starlogo.models.text.TextWords;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * A COLLADA skin: its joints' names and matrices, and their weights at each point. Its steps read them. All instances share it.
     */
    internal final class ColladaSkin extends StepSequence
    {
        private static const INFLUENCES_PER_STEP:int = 2000;

        // How far a number in the last row of an inverse matrix may be from 0 or 1. Programs invert matrices in 32 bits and write few digits.
        private static const LAST_ROW_TOLERANCE:Number = 1e-4;

        /** The skin's element. */
        public var element:ColladaElement;

        /** What takes the points to where the skin was bound. */
        public var bindShape:AffineTransform;

        /** What each point follows, when no step is left. Joint -1, which does not move, has the index after the last joint. */
        public var influences:JointInfluences = new JointInfluences();

        private var _names:ColladaAccessor = null; // of the joints

        // what takes points from where the skin was bound into each joint
        private var _inverseBindMatrices:Vector.<AffineTransform> = null;

        // lists of the joints' elements, by the index of an element that instantiates the skin
        private var _joints:Object = {};

        /** @param element the skin's element @throws ModelError if its bind shape matrix is wrong */
        public function ColladaSkin(element:ColladaElement)
        {
            this.element = element;
            var matrix:ColladaElement = element.child("bind_shape_matrix");
            bindShape = matrix == null ? new AffineTransform() : matrix.toTransform();
            call(function():void
                {
                    readJoints(element.requiredChild("joints"));
                }).begin(readingWeights);
        }

        /**
         * What moves points to the scene: by each joint, and last by joint -1. All must be read.
         *
         * @param scene has the joints
         * @param node the node with the skin
         * @param instance the element that instantiates the skin, with its skeletons
         * @throws ModelError if there is no such joint
         */
        public function jointMatricesOf(scene:ColladaScene, node:int, instance:ColladaElement):Vector.<AffineTransform>
        {
            var joints:Vector.<ColladaElement> = _joints[instance.index] ||= jointsOf(instance);
            element.budget.spendNumbers(joints.length, element);
            var jointMatrices:Vector.<AffineTransform> = new Vector.<AffineTransform>();
            for (var i:int = 0; i < joints.length; i++)
            {
                jointMatrices.push(scene.jointTransform(joints[i], node, element).after(_inverseBindMatrices[i]).after(bindShape));
            }
            jointMatrices.push(bindShape);
            return jointMatrices;
        }

        private function readJoints(joints:ColladaElement):void
        {
            _names = ColladaAccessor.read(joints, "JOINT", ColladaAccessor.NAMES, element);
            var matrices:ColladaAccessor = ColladaAccessor.read(joints, "INV_BIND_MATRIX", ["float_array"], element);
            joints.refuseIf(_names.words.length == 0 || matrices.count != _names.words.length || matrices.stride != ColladaTransform.MATRIX_SIZE,
                    "expected at least one joint, and a matrix for each, but found " + _names.words.length + " and " + matrices.count);
            _inverseBindMatrices = new Vector.<AffineTransform>();
            var all:Vector.<Number> = matrices.toNumbers();
            for (var i:int = 0; i < _names.words.length; i++)
            {
                var numbers:Vector.<Number> = all.slice(i * matrices.stride, (i + 1) * matrices.stride);
                _inverseBindMatrices.push(ColladaTransform.matrix(matrices.array, numbers, LAST_ROW_TOLERANCE));
            }
        }

        private function readingWeights():Steps
        {
            var weighted:ColladaElement = element.requiredChild("vertex_weights");
            var weights:ColladaAccessor = ColladaAccessor.read(weighted, "WEIGHT", ["float_array"], element);
            var stride:int = weighted.inputStride();
            var jointOffset:Number = weighted.requiredInput("JOINT").integer("offset", 0);
            var weightOffset:Number = weighted.child("input", "WEIGHT").integer("offset", 0);
            var indices:Array = weighted.child("v") == null ? [] : TextWords.of(weighted.child("v").countedText());
            weighted.refuseIf(indices.length % stride != 0, "expected " + stride + " indices for each joint of a point, but found " + indices.length + " in all");
            var influenceCount:int = indices.length / stride;
            return new StepSequence().add(readingCounts(weighted, influenceCount)).slices(influenceCount, INFLUENCES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        var joint:int = weighted.toInteger(indices[i * stride + jointOffset], -1, _inverseBindMatrices.length - 1, "a joint's index");
                        var weight:int = weighted.toInteger(indices[i * stride + weightOffset], 0, weights.count - 1, "a weight's index");
                        influences.joints.push(joint < 0 ? _inverseBindMatrices.length : joint);
                        influences.weights.push(weights.array.toNumber(weights.words[weight * weights.stride]));
                    }
                });
        }

        // The steps that read how many influences each point has.
        private function readingCounts(weighted:ColladaElement, influenceCount:int):Steps
        {
            var counts:Array = TextWords.of(weighted.requiredChild("vcount").countedText());
            var sum:Number = 0;
            weighted.checkCount(counts.length, "numbers in <vcount>");
            return new StepSequence().slices(counts.length, INFLUENCES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        sum += weighted.toInteger(counts[i], 0, influenceCount, "the number of a point's joints");
                        influences.offsets.push(sum);
                    }
                }).call(function():void
                {
                    weighted.refuseIf(sum != influenceCount, "its <vcount> adds up to " + sum + " joints, but <v> has " + influenceCount);
                });
        }

        // The elements of the joints at an element that instantiates the skin.
        private function jointsOf(instance:ColladaElement):Vector.<ColladaElement>
        {
            var joints:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            // names are sids in the skeletons; other references are ids
            var nodes:Object = _names.array.name == "Name_array" ? nodesBySid(instance) : null;
            for each (var name:String in _names.words)
            {
                var node:ColladaElement = nodes == null ? instance.elementAt("node", "#" + name) : nodes[keyOf(name)];
                _names.array.refuseIf(node == null, "there is no joint \"" + shortened(name) + "\" in the skeleton");
                joints.push(node);
            }
            return joints;
        }

        // The nodes of the skeletons, by their sids. The first node with a sid counts.
        private static function nodesBySid(instance:ColladaElement):Object
        {
            var nodes:Object = {};
            var pending:Vector.<ColladaElement> = skeletonsOf(instance).reverse();
            while (pending.length > 0)
            {
                var node:ColladaElement = pending.pop();
                instance.budget.spendNumbers(1 + node.children.length, instance);
                nodes[keyOf(node.attribute("sid"))] ||= node;
                for each (var child:ColladaElement in node.childrenNamed("node").reverse())
                {
                    pending.push(child);
                }
            }
            return nodes;
        }

        // The roots of the skeletons. If none is named, the node or scene around all.
        private static function skeletonsOf(instance:ColladaElement):Vector.<ColladaElement>
        {
            var roots:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            for each (var skeleton:ColladaElement in instance.childrenNamed("skeleton"))
            {
                var url:String = TextWords.trimmed(skeleton.text);
                var root:ColladaElement = skeleton.elementAt("node", url) || skeleton.elementAt("visual_scene", url);
                skeleton.refuseIf(root == null, "there is no <node> with the id \"" + shortened(url.substr(1)) + "\"");
                roots.push(root);
            }
            for (root = instance; roots.length == 0; root = root.parent)
            {
                if (root.parent.name != "node" && root.parent.name != "visual_scene")
                {
                    roots.push(root);
                }
            }
            return roots;
        }
    }
}
