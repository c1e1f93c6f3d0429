package starlogo.models.gltf
{
    import starlogo.models.building.AffineTransform;
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
        private var _positions:GltfAccessor;
        private var _vertices:Vector.<Number>;
        // the points before the node places them
        private var _points:Vector.<Number>;
        // What moves the points: the joints of a skin, or the transform of the node.
        private var _skin:GltfSkin = null;
        private var _transform:AffineTransform;

        /**
         * @param file the file
         * @param scene knows the nodes' transforms
         * @param node the index of the node that has the primitive
         * @param primitive the primitive
         * @param weights the weights of its morph targets
         * @param positions the vertices of its mesh
         * @param vertices takes its vertices
         */
        public function GltfVertices(file:GltfFile, scene:GltfScene, node:int, primitive:GltfJson, weights:Vector.<Number>,
                positions:GltfAccessor, vertices:Vector.<Number>)
        {
            _node = file.json.fileEntry("nodes", node);
            _positions = positions;
            _vertices = vertices;
            _points = positions.numbers;
            firstVertex = vertices.length / 3;
            count = positions.count;
            file.limits.requireMesh(firstVertex + Number(count), 0, primitive.place);
            add(positions);
            addTargets(file, primitive, weights);
            var skin:int = _node.reference("skin", "skins");
            var attributes:GltfJson = primitive.object("attributes");
            if (skin >= 0 && attributes.has("JOINTS_0"))
            {
                _skin = scene.skin(skin);
                add(_skin).call(copyPoints);
                addSkin(file, attributes);
            }
            _transform = _skin == null ? scene.globalTransformOf(node) : new AffineTransform();
            slices(count, VERTICES_PER_STEP, placeVertices);
        }

        /** Whether the node mirrors, or the first joint of its skin. Read it when no step is left. */
        public function get isMirror():Boolean
        {
            return (_skin == null ? _transform : _skin.joints[0]).isMirror;
        }

        private function addTargets(file:GltfFile, primitive:GltfJson, weights:Vector.<Number>):void
        {
            var targetCount:int = primitive.count("targets");
            for (var i:int = 0; i < targetCount && i < weights.length; i++)
            {
                var index:int = primitive.element("targets", i).reference("POSITION", "accessors");
                if (index >= 0 && weights[i] != 0)
                {
                    addTarget(file.accessor(index, "VEC3"), weights[i]);
                    file.limits.countNumbers(3 * Number(count), primitive.place);
                }
            }
        }

        private function addTarget(target:GltfAccessor, weight:Number):void
        {
            addAccessor(target);
            call(copyPoints).slices(3 * count, 3 * VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        _points[i] += weight * target.numbers[i];
                    }
                });
        }

        // copied, because other nodes may have the same mesh
        private function copyPoints():void
        {
            _points = _points == _positions.numbers ? _points.slice() : _points;
        }

        // The weights of a point are divided by their sum. A point without weights moves with the first joint.
        private function addSkin(file:GltfFile, attributes:GltfJson):void
        {
            // pairs: the indices of joints, and their weights
            var sets:Vector.<GltfAccessor> = new Vector.<GltfAccessor>();
            for (var i:int = 0; attributes.has("JOINTS_" + i); i++)
            {
                for each (var key:String in ["JOINTS_" + i, "WEIGHTS_" + i])
                {
                    var index:int = attributes.reference(key, "accessors");
                    attributes.refuseIf(index < 0, "a mesh has no weights for its joints");
                    sets.push(addAccessor(file.accessor(index, "VEC4")));
                }
            }
            file.limits.countNumbers(2 * count * Number(sets.length), attributes.place);
            slices(count, SKINNED_PER_STEP, function(first:int, end:int):void
                {
                    moveByJoints(sets, first, end);
                });
        }

        // Adds the steps of an accessor that has an element for each vertex.
        private function addAccessor(accessor:GltfAccessor):GltfAccessor
        {
            accessor.json.refuseIf(accessor.count != count, "it has " + accessor.count + " elements, but there are " + count + " vertices");
            add(accessor);
            return accessor;
        }

        private function moveByJoints(sets:Vector.<GltfAccessor>, first:int, end:int):void
        {
            var points:Vector.<Number> = _points;
            var result:Vector.<Number> = new Vector.<Number>(3);
            for (var i:int = first; i < end; i++)
            {
                var at:int = 3 * i;
                var sum:Number = 0;
                var x:Number = 0;
                var y:Number = 0;
                var z:Number = 0;
                for (var k:int = 0; k < sets.length; k += 2)
                {
                    for (var j:int = 4 * i; j < 4 * i + 4; j++)
                    {
                        var weight:Number = sets[k + 1].numbers[j];
                        if (weight != 0)
                        {
                            jointAt(sets[k], j).transformPoints(points, i, i + 1, result, 0);
                            sum += weight;
                            x += weight * result[0];
                            y += weight * result[1];
                            z += weight * result[2];
                        }
                    }
                }
                if (sum == 0)
                {
                    _skin.joints[0].transformPoints(points, i, i + 1, points, i);
                    continue;
                }
                points[at] = x / sum;
                points[int(at + 1)] = y / sum;
                points[int(at + 2)] = z / sum;
            }
        }

        private function jointAt(numbers:GltfAccessor, at:int):AffineTransform
        {
            var joint:Number = numbers.numbers[at];
            if (!(joint >= 0 && joint < _skin.joints.length && int(joint) == joint))
            {
                throw numbers.json.error("vertex " + (at >> 2) + " names joint " + joint + ", but there are only " + _skin.joints.length);
            }
            return _skin.joints[int(joint)];
        }

        private function placeVertices(first:int, end:int):void
        {
            if (!_transform.transformPoints(_points, first, end, _vertices, firstVertex + first))
            {
                throw _node.error("its vertices are not finite numbers, or are too large at the node's place (" + _positions.json.place + ")");
            }
        }
    }
}
