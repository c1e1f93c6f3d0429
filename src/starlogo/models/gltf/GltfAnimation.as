package starlogo.models.gltf
{
    import starlogo.models.animation.FileAnimation;
    import starlogo.models.animation.FilePose;
    import starlogo.models.building.ModelBuilder;
    import starlogo.steps.StepSequence;
    import starlogo.steps.finish;

    /**
     * An animation of a glTF file. At each time it gives numbers to properties of nodes. <code>GltfScene.targetOf()</code> returns a
     * property's target.
     *
     * @private
     */
    public final class GltfAnimation extends StepSequence implements FileAnimation
    {
        private static const PATHS:Array = ["translation", "rotation", "scale", "weights"];

        private var _name:String;
        private var _file:GltfFile;
        private var _upAxis:Object;

        // The samplers, by target.
        private var _samplers:Object = {};

        /**
         * @param file the file; all its steps must be done
         * @param index the animation's index
         * @param upAxis as for GltfReader
         * @throws ModelError if it is wrong
         */
        public function GltfAnimation(file:GltfFile, index:int, upAxis:Object)
        {
            var animation:GltfJson = file.json.fileEntry("animations", index);
            _name = animation.text("name") || "";
            _file = file;
            _upAxis = upAxis;
            var channelCount:int = animation.count("channels");
            var samplerCount:int = animation.count("samplers");
            for (var i:int = 0; i < channelCount; i++)
            {
                var channel:GltfJson = animation.element("channels", i);
                var target:GltfJson = channel.object("target");
                channel.refuseIf(target == null, "expected a target");
                var node:int = target.reference("node", "nodes");
                var path:String = target.text("path");
                // the target of an extension
                if (node < 0 || PATHS.indexOf(path) < 0)
                {
                    continue;
                }
                target.refuseIf(target.fileEntry("nodes", node).has("matrix") && path != "weights", "a node with a matrix can't be animated");
                var sampler:GltfJson = animation.element("samplers", channel.requiredWhole("sampler", samplerCount - 1));
                var reader:GltfSampler = new GltfSampler(file, sampler, path);
                _samplers[GltfScene.targetOf(node, path)] = reader;
                add(reader);
            }
        }

        /** Reads the animations of a file, whose steps are all done. @throws ModelError if one is wrong */
        public static function allIn(file:GltfFile, upAxis:Object):Vector.<FileAnimation>
        {
            var animations:Vector.<FileAnimation> = new Vector.<FileAnimation>();
            for (var i:int = 0; i < file.json.count("animations"); i++)
            {
                var animation:GltfAnimation = new GltfAnimation(file, i, upAxis);
                finish(animation);
                animations.push(animation);
            }
            return animations;
        }

        /** @inheritDoc */
        public function get name():String
        {
            return _name;
        }

        /** @inheritDoc */
        public function get duration():Number
        {
            var most:Number = 0;
            for each (var sampler:GltfSampler in _samplers)
            {
                most = Math.max(most, sampler.end);
            }
            return most;
        }

        /** @inheritDoc */
        public function verticesAt(time:Number):Vector.<Number>
        {
            _file.limits.restart();
            return ModelBuilder.verticesOf(new GltfReader(_file, _upAxis, null, new FilePose(this, time)));
        }

        /** @inheritDoc */
        public function numbersAt(target:Object, time:Number):Vector.<Number>
        {
            var sampler:GltfSampler = _samplers[target];
            return sampler == null ? null : sampler.valueAt(time);
        }
    }
}
