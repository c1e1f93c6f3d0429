package starlogo.models.gltf
{
    import starlogo.models.AffineTransform;
    import starlogo.models.ModelError;
    import starlogo.models.ModelBudget;
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;

    /** Adds the vertices of a primitive to a model, at the place of a node, in steps. They are morphed, and moved by their skin at rest. */
    internal final class GltfPoints extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 4000;

        /** The index in the model of the first vertex. */
        public var firstVertex:int;

        /** The number of vertices, when no step is left. */
        public var count:int;

        /** The points before the node places them, morphed and skinned when the steps that do so are done. */
        internal var numbers:Vector.<Number>;

        private var _name:String;
        private var _node:String;
        private var _source:GltfAccessor;
        private var _vertices:Vector.<Number>;
        private var _skin:GltfSkin = null;
        private var _world:AffineTransform;

        /**
         * @param file the file
         * @param scene knows the nodes' transforms
         * @param node the node that has the primitive
         * @param primitive the primitive
         * @param place its place in the file, for errors
         * @param weights the weights of its morph targets
         * @param source the vertices of its mesh
         * @param vertices takes its vertices
         */
        public function GltfPoints(file:GltfFile, scene:GltfScene, node:int, primitive:Object, place:String, weights:Vector.<Number>,
                source:GltfAccessor, vertices:Vector.<Number>)
        {
            var json:GltfJson = file.json;
            _name = json.name;
            _node = "nodes[" + node + "]";
            _source = source;
            _vertices = vertices;
            numbers = source.numbers;
            firstVertex = vertices.length / 3;
            count = source.count;
            file.budget.require(ModelBudget.VERTICES, firstVertex + Number(count), place);
            add(source);
            addTargets(file, json.listIn(primitive, "targets", place), place, weights);
            var skin:int = json.reference(json.entry("nodes", node), "skin", _node, "skins");
            if (skin >= 0 && primitive.attributes.JOINTS_0 !== undefined)
            {
                _skin = new GltfSkin(file, scene.jointsOf(file, skin), primitive.attributes, place + ".attributes", this);
                call(copyNumbers).add(_skin);
            }
            _world = _skin == null ? scene.worldOf(node) : new AffineTransform();
            slices(count, VERTICES_PER_STEP, placeVertices);
        }

        /** Whether the node mirrors. */
        public function get isMirror():Boolean
        {
            return _skin == null ? _world.isMirror : _skin.isMirror;
        }

        private function addTargets(file:GltfFile, targets:Array, place:String, weights:Vector.<Number>):void
        {
            for (var i:int = 0; i < targets.length && i < weights.length; i++)
            {
                var where:String = place + ".targets";
                var index:int = file.json.reference(file.json.elementOf(targets, i, where), "POSITION", where + "[" + i + "]", "accessors");
                if (index >= 0 && weights[i] != 0)
                {
                    addTarget(file.accessor(index, "VEC3"), weights[i]);
                    file.budget.take(ModelBudget.NUMBERS, 3 * Number(count), place);
                }
            }
        }

        private function addTarget(target:GltfAccessor, weight:Number):void
        {
            refuseIf(target.count != count, _name, "it has " + target.count + " elements, but there are " + count + " vertices", target.place);
            add(target).call(copyNumbers).slices(3 * count, 3 * VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        numbers[i] += weight * target.numbers[i];
                    }
                });
        }

        // copied, because other nodes may have the same mesh
        private function copyNumbers():void
        {
            numbers = numbers == _source.numbers ? numbers.slice() : numbers;
        }

        private function placeVertices(first:int, end:int):void
        {
            if (!_world.place(numbers, first, end, _vertices, firstVertex + first))
            {
                throw new ModelError(_name, _node, "its vertices are not finite numbers, or are too large at the node's place (" + _source.place + ")");
            }
        }
    }
}
