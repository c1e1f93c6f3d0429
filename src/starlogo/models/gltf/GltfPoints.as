package starlogo.models.gltf
{
    import starlogo.models.AffineTransform;
    import starlogo.models.ModelError;
    import starlogo.models.ModelBudget;
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Adds the vertices of a primitive to a model, at the place of a node, in steps. They are morphed, and moved by their skin at rest. */
    internal final class GltfPoints extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 4000;

        /** The index in the model of the first vertex. */
        public var firstVertex:int;

        /** The number of vertices, when no step is left. */
        public var count:int;

        private var _file:GltfFile;
        private var _scene:GltfScene;
        private var _node:int;
        private var _skinIndex:int;
        private var _attributes:Object;
        private var _place:String;
        private var _source:GltfAccessor;
        private var _vertices:Vector.<Number>;
        private var _points:Vector.<Number>;
        private var _skin:GltfSkin = null;
        private var _world:AffineTransform;

        /**
         * @param file the file
         * @param scene knows the nodes' transforms
         * @param node the node that has the primitive
         * @param primitive the primitive
         * @param place its place in the file, for errors
         * @param weights the weights of its morph targets
         * @param source the vertices of its mesh; its steps may still be running
         * @param vertices takes its vertices
         */
        public function GltfPoints(file:GltfFile, scene:GltfScene, node:int, primitive:Object, place:String, weights:Vector.<Number>,
                source:GltfAccessor, vertices:Vector.<Number>)
        {
            var json:GltfJson = file.json;
            _file = file;
            _scene = scene;
            _node = node;
            _attributes = json.objectIn(primitive, "attributes", place);
            _place = place;
            _source = source;
            _vertices = vertices;
            _points = source.numbers;
            _skinIndex = json.reference(json.entry("nodes", node), "skin", "nodes[" + node + "]", "skins");
            if (_attributes.JOINTS_0 === undefined)
            {
                _skinIndex = -1;
            }
            firstVertex = vertices.length / 3;
            count = source.count;
            file.budget.require(ModelBudget.VERTICES, firstVertex + Number(count), place);
            addTargets(json, json.listIn(primitive, "targets", place), weights);
            begin(skinning).slices(count, VERTICES_PER_STEP, placeVertices);
        }

        /** Whether the node mirrors. */
        public function get isMirror():Boolean
        {
            return _skin == null ? _world.isMirror : _skin.isMirror;
        }

        private function addTargets(json:GltfJson, targets:Array, weights:Vector.<Number>):void
        {
            for (var i:int = 0; i < targets.length && i < weights.length; i++)
            {
                var where:String = _place + ".targets";
                var index:int = json.reference(json.elementOf(targets, i, where), "POSITION", where + "[" + i + "]", "accessors");
                if (index >= 0 && weights[i] != 0)
                {
                    addTarget(json, _file.accessor(index, "VEC3"), weights[i]);
                }
            }
        }

        private function addTarget(json:GltfJson, target:GltfAccessor, weight:Number):void
        {
            refuseIf(target.count != count, json.name, "it has " + target.count + " elements, but there are " + count + " vertices", target.place);
            _file.budget.take(ModelBudget.NUMBERS, 3 * Number(count), _place);
            add(target).call(copyPoints).slices(3 * count, 3 * VERTICES_PER_STEP, function(first:int, end:int):void
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
            if (_points == _source.numbers)
            {
                _points = _points.slice();
            }
        }

        private function skinning():Steps
        {
            if (_skinIndex < 0)
            {
                _world = _scene.worldOf(_node);
                return null;
            }
            copyPoints();
            _world = new AffineTransform();
            _skin = new GltfSkin(_file, _scene.jointsOf(_file, _skinIndex), _attributes, _place + ".attributes", _points);
            return _skin;
        }

        private function placeVertices(first:int, end:int):void
        {
            if (!_world.place(_points, first, end, _vertices, firstVertex + first))
            {
                throw new ModelError(_file.json.name, "nodes[" + _node + "]", "its vertices are not finite numbers, or are too large at the node's place (" +
                        _source.place + ")");
            }
        }
    }
}
