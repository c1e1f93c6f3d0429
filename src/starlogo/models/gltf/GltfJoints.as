package starlogo.models.gltf
{
    import starlogo.models.AffineTransform;
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;

    /** Finds how the joints of a skin move points at rest, in steps. */
    internal final class GltfJoints extends StepSequence
    {
        private static const JOINTS_PER_STEP:int = 200;

        /** A transform for each joint, when no step is left. */
        public var transforms:Vector.<AffineTransform> = new Vector.<AffineTransform>();

        private var _json:GltfJson;
        private var _scene:GltfScene;
        private var _place:String;
        private var _list:Array;
        private var _matrices:GltfAccessor = null;

        /**
         * @param file the file
         * @param scene knows the joints' places
         * @param index the skin's index
         */
        public function GltfJoints(file:GltfFile, scene:GltfScene, index:int)
        {
            _json = file.json;
            _scene = scene;
            _place = "skins[" + index + "]";
            var skin:Object = _json.entry("skins", index);
            _list = _json.listIn(skin, "joints", _place);
            refuseIf(_list.length == 0, _json.name, "expected at least one joint", _place + ".joints");
            var matrices:int = _json.reference(skin, "inverseBindMatrices", _place, "accessors");
            if (matrices >= 0)
            {
                _matrices = file.accessor(matrices, "MAT4");
                refuseIf(_matrices.count < _list.length, _json.name, "there are " + _list.length + " joints, but fewer matrices", _matrices.place);
                add(_matrices);
            }
            slices(_list.length, JOINTS_PER_STEP, find);
        }

        private function find(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var world:AffineTransform = _scene.worldOf(_json.numberOf(_list[i], _place + ".joints[" + i + "]", "nodes"));
                transforms.push(_matrices == null ? world : world.after(GltfScene.ofColumns(_matrices.numbers, 16 * i)));
            }
        }
    }
}
