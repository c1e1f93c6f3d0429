package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.shortened;
    import starlogo.models.text.TextWords;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** The joints of a COLLADA skin, and their weights at each point. Its steps read them. */
    internal final class ColladaSkin extends StepSequence
    {
        private static const POINTS_PER_STEP:int = 1000;
        private static const INFLUENCES_PER_STEP:int = 2000;
        private static const MATRIX:int = 16;

        // programs invert matrices in 32 bits, and their last rows are rounded then
        private static const TOLERANCE:Number = 1e-6;

        private var _skin:ColladaElement;

        // takes the points to where the skin was bound
        private var _shape:AffineTransform;

        // The joints, and what takes points from where the skin was bound into each joint.
        private var _nodes:Vector.<ColladaElement> = new Vector.<ColladaElement>();
        private var _inverses:Vector.<AffineTransform> = new Vector.<AffineTransform>();

        // The influences of all points. Those of a point begin at _starts, which has an end after the last point. Joint -1 does not move.
        private var _starts:Vector.<int> = new <int>[0];
        private var _joints:Vector.<int> = new Vector.<int>();
        private var _weights:Vector.<Number> = new Vector.<Number>();

        /**
         * @param skin the skin's element
         * @param instance the element that places it, with its skeletons
         * @throws ModelError if the skin is wrong
         */
        public function ColladaSkin(skin:ColladaElement, instance:ColladaElement)
        {
            _skin = skin;
            var shape:ColladaElement = skin.child("bind_shape_matrix");
            _shape = shape == null ? new AffineTransform() : shape.toTransform();
            call(function():void
                {
                    readJoints(skin.requiredChild("joints"), instance);
                }).begin(readingWeights);
        }

        /** What moves points to the scene by joint -1, 0, 1, ... @param place where the skin is in the scene */
        public function paletteOf(scene:ColladaScene, place:ColladaPlace):Vector.<AffineTransform>
        {
            _skin.limits.countElements(_nodes.length, _skin);
            var palette:Vector.<AffineTransform> = new <AffineTransform>[_shape];
            for (var i:int = 0; i < _nodes.length; i++)
            {
                palette.push(scene.jointAt(_nodes[i], place, _skin).after(_inverses[i]).after(_shape));
            }
            return palette;
        }

        /** The steps that move points by a palette. */
        public function moving(points:Vector.<Number>, palette:Vector.<AffineTransform>):Steps
        {
            var count:int = _starts.length - 1;
            _skin.refuseIf(points.length != 3 * count, "it has weights for " + count + " points, but its geometry has " + points.length / 3);
            _skin.limits.countNumbers(2 * _joints.length, _skin);
            return new StepSequence().slices(count, POINTS_PER_STEP, function(first:int, end:int):void
                {
                    move(points, palette, first, end);
                });
        }

        // The weights of a point are divided by their sum. A point without weights moves with the first joint.
        private function move(points:Vector.<Number>, palette:Vector.<AffineTransform>, first:int, end:int):void
        {
            var moved:Vector.<Number> = new Vector.<Number>(3);
            for (var i:int = first; i < end; i++)
            {
                var sum:Number = 0;
                var x:Number = 0;
                var y:Number = 0;
                var z:Number = 0;
                for (var k:int = _starts[i]; k < _starts[i + 1]; k++)
                {
                    var weight:Number = _weights[k];
                    palette[_joints[k] + 1].transformPoints(points, i, i + 1, moved, 0);
                    sum += weight;
                    x += weight * moved[0];
                    y += weight * moved[1];
                    z += weight * moved[2];
                }
                if (sum == 0)
                {
                    palette[1].transformPoints(points, i, i + 1, points, i);
                    continue;
                }
                points[3 * i] = x / sum;
                points[3 * i + 1] = y / sum;
                points[3 * i + 2] = z / sum;
            }
        }

        private function readJoints(joints:ColladaElement, instance:ColladaElement):void
        {
            var names:ColladaList = ColladaList.of(joints, "JOINT", ColladaList.NAMES, _skin);
            var matrices:ColladaList = ColladaList.of(joints, "INV_BIND_MATRIX", ["float_array"], _skin);
            joints.refuseIf(names.words.length == 0 || matrices.count != names.words.length || matrices.width != MATRIX,
                    "expected at least one joint, and a matrix for each, but found " + names.words.length + " and " + matrices.count);
            // names are sids in the skeletons; other references are ids
            var nodes:Object = names.array.name == "Name_array" ? nodesBySid(instance) : null;
            for (var i:int = 0; i < names.words.length; i++)
            {
                var node:ColladaElement = nodes == null ? _skin.elementWith("node", names.words[i]) : nodes["#" + names.words[i]];
                names.array.refuseIf(node == null, "there is no joint \"" + shortened(names.words[i]) + "\" in the skeleton");
                _nodes.push(node);
                _inverses.push(ColladaTransform.matrix(matrices.array, matrices.numbers.slice(MATRIX * i, MATRIX * i + MATRIX), TOLERANCE));
            }
        }

        // The nodes of the skeletons, by "#" and sid. The first node with a sid counts.
        private static function nodesBySid(instance:ColladaElement):Object
        {
            var nodes:Object = {};
            var pending:Vector.<ColladaElement> = skeletonsOf(instance).reverse();
            while (pending.length > 0)
            {
                var node:ColladaElement = pending.pop();
                instance.limits.countElements(1 + node.children.length, instance);
                nodes["#" + node.attribute("sid")] ||= node;
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
                var url:String = TextWords.of(skeleton.text).join(" ");
                var root:ColladaElement = skeleton.elementAtUrl("node", url) || skeleton.elementAtUrl("visual_scene", url);
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

        private function readingWeights():Steps
        {
            var element:ColladaElement = _skin.requiredChild("vertex_weights");
            var weights:ColladaList = ColladaList.of(element, "WEIGHT", ["float_array"], _skin);
            var stride:Number = 1;
            for each (var input:ColladaElement in element.childrenNamed("input"))
            {
                stride = Math.max(stride, input.integer("offset", 0) + 1);
            }
            element.refuseIf(element.child("input", "JOINT") == null, "expected an <input> with the semantic JOINT");
            var joint:Number = element.child("input", "JOINT").integer("offset", 0);
            var weight:Number = element.child("input", "WEIGHT").integer("offset", 0);
            var indices:Array = element.child("v") == null ? [] : element.child("v").countedWords();
            var influences:Number = indices.length / stride;
            return new StepSequence().add(readingCounts(element, influences)).slices(influences, INFLUENCES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        _joints.push(element.toWholeNumber(indices[i * stride + joint], -1, _nodes.length - 1, "a joint's index"));
                        var index:int = element.toWholeNumber(indices[i * stride + weight], 0, weights.words.length - 1, "a weight's index");
                        _weights.push(weights.array.toNumber(weights.words[index]));
                    }
                });
        }

        // The steps that read how many influences each point has. There are as many as given.
        private function readingCounts(element:ColladaElement, influences:Number):Steps
        {
            var counts:Array = element.requiredChild("vcount").countedWords();
            var sum:Number = 0;
            element.checkCount(counts.length, "numbers in <vcount>");
            return new StepSequence().slices(counts.length, INFLUENCES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        sum += element.toWholeNumber(counts[i], 0, influences, "the number of a point's joints");
                        _starts.push(sum);
                    }
                }).call(function():void
                {
                    element.refuseIf(sum != influences, "its <vcount> adds up to " + sum + " joints, but <v> has " + influences);
                });
        }
    }
}
