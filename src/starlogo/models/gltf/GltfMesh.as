package starlogo.models.gltf
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.building.TriangleLabels;
    import starlogo.models.scene.DeformedPoints;
    import starlogo.models.scene.JointInfluences;
    import starlogo.models.scene.Scene;
    import starlogo.models.scene.SceneMesh;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * A mesh of a glTF file, and what its vertices follow: the joints of a skin, and morph targets. All nodes that have both the mesh and the skin
     * share it.
     */
    internal final class GltfMesh extends SceneMesh
    {
        private static const VERTICES_PER_STEP:int = 2000;
        private static const TRIANGLES_PER_STEP:int = 5000;

        // modes of primitives: strips have the one between these, and points and lines have lower ones
        private static const TRIANGLES:int = 4;
        private static const FAN:int = 6;

        /** Whether vertices are moved by a skin or by morph targets. */
        public var isDeformed:Boolean;

        private var _file:GltfFile;
        private var _skin:GltfJson;
        private var _jointCount:int;

        // What each vertex follows: joints of the skin, or the node itself, which has the index after the last joint. Null without a skin.
        private var _influences:JointInfluences;

        // whether a vertex follows a joint
        private var _hasJoints:Boolean = false;

        private var _morphed:Vector.<GltfJson> = new Vector.<GltfJson>(); // the primitives with morph targets

        // For each list of positions, its first vertex in the mesh. The key is the accessor's place in the file. For a primitive that shares its vertices
        // with no other one, the primitive's place comes after it.
        private var _firstVertices:Object = {};

        /**
         * @param file the file; all its steps must be done
         * @param json the mesh
         * @param skin null for none
         */
        public function GltfMesh(file:GltfFile, json:GltfJson, skin:GltfJson)
        {
            _file = file;
            _skin = skin;
            _jointCount = skin == null ? 0 : skin.count("joints");
            _influences = skin == null ? null : new JointInfluences();
            isDeformed = skin != null;
            for (var i:int = 0; i < json.count("primitives") && !isDeformed; i++)
            {
                isDeformed = json.element("primitives", i).has("targets");
            }
            beginEach(json.count("primitives"), function(index:int):Steps
                {
                    return readingPrimitive(json.element("primitives", index));
                });
        }

        /**
         * The steps that move the points of an instance by the morph targets, and then by the skin.
         *
         * @param deformed the points
         * @param weights of the morph targets
         * @param scene has the joints
         * @param node the instance's node
         */
        public function deforming(deformed:DeformedPoints, weights:Vector.<Number>, scene:Scene, node:int):Steps
        {
            return new StepSequence().beginEach(_morphed.length, function(index:int):Steps
                {
                    var primitive:GltfJson = _morphed[index];
                    var rest:GltfAccessor = _file.accessorOf(primitive.object("attributes"), "POSITION", "VEC3");
                    // the primitive may have a target for each weight
                    _file.budget.spendElements(weights.length, primitive.place);
                    return new StepSequence().beginEach(Math.min(primitive.count("targets"), weights.length), function(target:int):Steps
                        {
                            var deltas:GltfAccessor = weights[target] == 0 ? null : _file.accessorOf(primitive.element("targets", target), "POSITION", "VEC3");
                            if (deltas == null)
                            {
                                return null;
                            }
                            deltas.requireCount(rest.count);
                            _file.budget.spendNumbers(deltas.numbers.length, primitive.place);
                            return new StepSequence().add(deltas).add(deformed.morphing(_firstVertices[rest.json.place + primitive.place], weights[target], deltas.numbers, null));
                        });
                }).begin(function():Steps
                {
                    return _hasJoints ? skinning(deformed, scene, node) : null;
                });
        }

        /** @inheritDoc It is the material's number in the file. */
        override public function labelOf(material:String, instance:Object, labels:TriangleLabels):int
        {
            return int(material);
        }

        // The steps that move points by the skin. After its joints there is the node itself, which vertices without joints follow.
        private function skinning(deformed:DeformedPoints, scene:Scene, node:int):Steps
        {
            var work:StepSequence = new StepSequence();
            _skin.refuseIf(_jointCount == 0, "expected at least one joint", "joints");
            var inverses:GltfAccessor = _file.accessorOf(_skin, "inverseBindMatrices", "MAT4");
            if (inverses != null)
            {
                inverses.json.refuseIf(inverses.count < _jointCount, "there are " + _jointCount + " joints, but fewer matrices");
                work.add(inverses);
            }
            _file.budget.spendNumbers(_jointCount, _skin.place);
            return work.begin(function():Steps
                {
                    var jointMatrices:Vector.<AffineTransform> = new Vector.<AffineTransform>();
                    for (var i:int = 0; i < _jointCount; i++)
                    {
                        var joint:AffineTransform = scene.transformOf(_skin.indexIn("joints", i, "nodes"));
                        jointMatrices.push(inverses == null ? joint : joint.after(GltfScene.transformOfColumns(inverses.numbers, 16 * i)));
                    }
                    jointMatrices.push(scene.transformOf(node));
                    return deformed.skinning(_influences, jointMatrices, _file.budget, _skin.place);
                });
        }

        // The steps that read a primitive: its vertices, and its triangles, which all have one material. No steps if it has no vertices.
        private function readingPrimitive(primitive:GltfJson):Steps
        {
            var work:StepSequence = new StepSequence();
            primitive.refuseIf(primitive.hasExtension(GltfFile.DRACO), "it is " + GltfFile.DRACO_PROBLEM);
            var attributes:GltfJson = primitive.object("attributes");
            var positions:GltfAccessor = attributes == null ? null : _file.accessorOf(attributes, "POSITION", "VEC3");
            if (positions == null)
            {
                return work;
            }
            // primitives may share their vertices and have different triangles
            var isPlain:Boolean = primitive.count("targets") == 0 && !attributes.has("JOINTS_0");
            var key:String = positions.json.place + (isPlain ? "" : primitive.place);
            if (!(key in _firstVertices))
            {
                _firstVertices[key] = points.length / 3;
                addVertices(work, primitive, attributes, positions);
            }
            var mode:int = primitive.integer("mode", FAN, TRIANGLES);
            if (mode >= TRIANGLES)
            {
                addTriangles(work, mode, primitive, _firstVertices[key], positions.count);
            }
            return work;
        }

        private function addVertices(work:StepSequence, primitive:GltfJson, attributes:GltfJson, positions:GltfAccessor):void
        {
            _file.budget.checkMeshSize(points.length / 3 + positions.count, 0, primitive.place);
            work.add(positions).call(function():void
                {
                    addPoints(positions.numbers);
                });
            if (primitive.count("targets") > 0)
            {
                _morphed.push(primitive);
            }
            if (_influences != null)
            {
                addInfluences(work, attributes, positions.count);
            }
        }

        // Adds the steps that read what vertices follow. Each set of joints has four numbers for a vertex, and so has the set of their weights.
        private function addInfluences(work:StepSequence, attributes:GltfJson, vertexCount:int):void
        {
            var joints:Vector.<GltfAccessor> = new Vector.<GltfAccessor>();
            var weights:Vector.<GltfAccessor> = new Vector.<GltfAccessor>();
            for (var i:int = 0; attributes.has("JOINTS_" + i); i++)
            {
                _hasJoints = true;
                joints.push(accessorOfVertices(work, attributes, "JOINTS_" + i, vertexCount));
                weights.push(accessorOfVertices(work, attributes, "WEIGHTS_" + i, vertexCount));
            }
            // sets may have the same accessors
            _file.budget.spendNumbers(4 * Number(vertexCount) * i, attributes.place);
            work.slices(vertexCount, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    for (var vertex:int = first; vertex < end; vertex++)
                    {
                        for (var setIndex:int = 0; setIndex < joints.length; setIndex++)
                        {
                            readSet(joints[setIndex], weights[setIndex], vertex);
                        }
                        if (joints.length == 0)
                        {
                            _influences.joints.push(_jointCount);
                            _influences.weights.push(1);
                        }
                        _influences.offsets.push(_influences.joints.length);
                    }
                });
        }

        private function accessorOfVertices(work:StepSequence, attributes:GltfJson, key:String, vertexCount:int):GltfAccessor
        {
            var found:GltfAccessor = _file.accessorOf(attributes, key, "VEC4");
            attributes.refuseIf(found == null, "a mesh has no weights for its joints");
            found.requireCount(vertexCount);
            work.add(found);
            return found;
        }

        // Reads the influences of a vertex in a set. A weight of 0 is none, whatever its joint is.
        private function readSet(joints:GltfAccessor, weights:GltfAccessor, vertex:int):void
        {
            for (var at:int = 4 * vertex; at < 4 * vertex + 4; at++)
            {
                var joint:Number = joints.numbers[at];
                if (weights.numbers[at] == 0)
                {
                    continue;
                }
                if (!(joint >= 0 && joint < _jointCount && int(joint) == joint))
                {
                    throw joints.json.error("vertex " + vertex + " names joint " + joint + ", but there are only " + _jointCount);
                }
                _influences.joints.push(joint);
                _influences.weights.push(weights.numbers[at]);
            }
        }

        // Adds the steps that read a primitive's triangles, by its indices if it has any. Triangle n of a list has the corners 3n, 3n+1 and 3n+2.
        private function addTriangles(work:StepSequence, mode:int, primitive:GltfJson, firstPoint:int, vertexCount:int):void
        {
            var indices:GltfAccessor = _file.accessorOf(primitive, "indices", "SCALAR");
            if (indices != null)
            {
                indices.json.refuseIf(!indices.areIndices, "indices must be 5121, 5123 or 5125, and not normalized", "componentType");
                work.add(indices);
            }
            var cornerCount:int = indices == null ? vertexCount : indices.count;
            var triangleCount:int = mode == TRIANGLES ? cornerCount / 3 : Math.max(0, cornerCount - 2);
            var material:String = String(primitive.indexOrNone("material", "materials"));
            var into:Vector.<uint> = corners;
            var start:int;
            // other primitives may have the same indices
            _file.budget.spendNumbers(3 * triangleCount, primitive.place);
            work.call(function():void
                {
                    beginPrimitive(material);
                    start = into.length;
                    into.length += 3 * triangleCount; // room for all at once
                }).slices(triangleCount, TRIANGLES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = 3 * first; i < 3 * end; i++)
                    {
                        var corner:int = mode == TRIANGLES ? i : cornerOf(int(i / 3), i % 3, mode == FAN);
                        var vertex:Number = indices == null ? corner : indices.numbers[corner];
                        if (vertex >= vertexCount)
                        {
                            throw indices.json.error("element " + corner + " names vertex " + vertex + ": " + primitive.place + " has " + vertexCount);
                        }
                        into[start + i] = firstPoint + int(vertex);
                    }
                });
        }

        // The index of a corner of triangle n. That of a fan has the corners n+1, n+2 and 0. In a strip it has n, n+1 and n+2; every second one is reversed.
        private static function cornerOf(triangle:int, corner:int, isFan:Boolean):int
        {
            return isFan ? (corner == 2 ? 0 : triangle + corner + 1) : triangle + (corner == 0 || (triangle & 1) == 0 ? corner : 3 - corner);
        }
    }
}
