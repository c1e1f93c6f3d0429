package starlogo.models.gltf
{
    import starlogo.models.animation.AnimationChannel;
    import starlogo.models.animation.AnimationSampler;
    import starlogo.models.animation.FileAnimation;
    import starlogo.steps.finish;

    /**
     * Reads the animations of a glTF file. They move properties of nodes. <code>GltfScene.targetOf()</code> returns a property's target.
     *
     * @private
     */
    public final class GltfAnimationReader
    {
        private static const TYPES:Object = {translation: "VEC3", rotation: "VEC4", scale: "VEC3", weights: "SCALAR"};
        private static const CUBIC:String = "CUBICSPLINE";

        /**
         * Reads the animations.
         *
         * @param file the file; all its steps must be done
         * @param upAxis as for GltfScene
         * @throws ModelError if one is wrong
         */
        public static function allIn(file:GltfFile, upAxis:Object):Vector.<FileAnimation>
        {
            var animations:Vector.<FileAnimation> = new Vector.<FileAnimation>();
            var scene:GltfScene = new GltfScene(file, upAxis, null);
            for (var i:int = 0; i < file.json.count("animations"); i++)
            {
                var animation:GltfJson = file.json.element("animations", i);
                animations.push(new FileAnimation(animation.textOrNull("name") || "", channelsOf(file, animation), scene));
            }
            if (animations.length > 0)
            {
                file.budget.reset();
                finish(scene);
            }
            return animations;
        }

        private static function channelsOf(file:GltfFile, animation:GltfJson):Vector.<AnimationChannel>
        {
            var channels:Vector.<AnimationChannel> = new Vector.<AnimationChannel>();
            for (var i:int = 0; i < animation.count("channels"); i++)
            {
                var channel:GltfJson = animation.element("channels", i);
                var target:GltfJson = channel.object("target");
                channel.refuseIf(target == null, "expected a target");
                var node:int = target.indexOrNone("node", "nodes");
                var path:String = target.textOrNull("path");
                // otherwise it is the target of an extension
                if (node >= 0 && TYPES.hasOwnProperty(path))
                {
                    target.refuseIf(file.json.rootEntry("nodes", node).has("matrix") && path != "weights", "a node with a matrix can't be animated");
                    var sampler:int = channel.requiredInteger("sampler", animation.count("samplers") - 1);
                    channels.push(new AnimationChannel(samplerOf(file, animation.element("samplers", sampler), path), GltfScene.targetOf(node, path)));
                }
            }
            return channels;
        }

        // Reads the keys of a sampler. @param path the property that they move
        private static function samplerOf(file:GltfFile, sampler:GltfJson, path:String):AnimationSampler
        {
            var interpolation:String = sampler.has("interpolation") ? sampler.textOrNull("interpolation") : AnimationSampler.LINEAR;
            sampler.refuseIf([AnimationSampler.LINEAR, AnimationSampler.STEP, CUBIC].indexOf(interpolation) < 0, "expected LINEAR, STEP or CUBICSPLINE", "interpolation");
            var times:GltfAccessor = file.accessorOf(sampler, "input", "SCALAR");
            var values:GltfAccessor = file.accessorOf(sampler, "output", TYPES[path]);
            sampler.refuseIf(times == null || values == null, "expected input and output");
            var wanted:Number = Number(times.count) * (interpolation == CUBIC ? 3 : 1);
            values.json.refuseIf(times.count == 0 || values.count < wanted || values.count % wanted != 0 || path != "weights" && values.count != wanted,
                    "it has " + values.count + " elements for " + times.count + " keys");
            // other channels may have the same accessors
            file.budget.spendNumbers(times.count + values.numbers.length, sampler.place);
            finish(times);
            finish(values);
            return interpolation == CUBIC ? splines(sampler, times.numbers, values.numbers, path == "rotation")
                : new AnimationSampler(sampler.modelName, sampler.place, times.numbers, values.numbers, [interpolation], null, null, path == "rotation");
        }

        // The keys of Hermite splines: for each key the tangents before it, the values, and the tangents after it (glTF specification, appendix
        // C). A control point of the same curve is a third of the tangent away from its key.
        private static function splines(sampler:GltfJson, times:Vector.<Number>, numbers:Vector.<Number>, areRotations:Boolean):AnimationSampler
        {
            var width:int = numbers.length / times.length / 3;
            var values:Vector.<Number> = new Vector.<Number>();
            var outControls:Vector.<Number> = new Vector.<Number>();
            var inControls:Vector.<Number> = new Vector.<Number>();
            for (var key:int = 0; key < times.length; key++)
            {
                for (var i:int = 3 * key * width; i < (3 * key + 1) * width; i++)
                {
                    var value:Number = numbers[i + width];
                    values.push(value);
                    outControls.push(key == times.length - 1 ? value : value + numbers[i + 2 * width] * (times[key + 1] - times[key]) / 3);
                    inControls.push(key == 0 ? value : value - numbers[i] * (times[key] - times[key - 1]) / 3);
                }
            }
            return new AnimationSampler(sampler.modelName, sampler.place, times, values, [CUBIC], outControls, inControls, areRotations);
        }
    }
}
