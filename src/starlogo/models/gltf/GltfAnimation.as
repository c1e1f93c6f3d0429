package starlogo.models.gltf
{
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;

    /**
     * An animation of a glTF file. At each time it gives numbers to properties of nodes, in place of those that the file has for them.
     *
     * @private
     */
    public final class GltfAnimation extends StepSequence
    {
        private static const PATHS:Array = ["translation", "rotation", "scale", "weights"];

        /** The animation's name; "" if it has none. */
        public var name:String;

        // The samplers, by the node's index, a space and the path; and the values of the time that was set last.
        private var _samplers:Object = {};
        private var _values:Object = {};

        /**
         * @param file the file; all its steps must be done
         * @param index the animation's index
         * @throws ModelError if it is wrong
         */
        public function GltfAnimation(file:GltfFile, index:int)
        {
            var json:GltfJson = file.json;
            var place:String = "animations[" + index + "]";
            var animation:Object = json.entry("animations", index);
            name = animation.name is String ? animation.name : "";
            var channels:Array = json.listIn(animation, "channels", place);
            var samplers:Array = json.listIn(animation, "samplers", place);
            for (var i:int = 0; i < channels.length; i++)
            {
                var where:String = place + ".channels[" + i + "]";
                var channel:Object = json.elementOf(channels, i, place + ".channels");
                var target:Object = json.objectIn(channel, "target", where);
                refuseIf(target == null, json.name, "expected a target", where);
                var node:int = json.reference(target, "node", where + ".target", "nodes");
                // the target of an extension
                if (node < 0 || PATHS.indexOf(target.path) < 0)
                {
                    continue;
                }
                refuseIf(json.entry("nodes", node).matrix !== undefined && target.path != "weights", json.name, "a node with a matrix can't be animated",
                        where + ".target");
                var number:int = json.whole(channel, "sampler", where, samplers.length - 1, -1);
                var sampler:Object = json.elementOf(samplers, number, place + ".samplers");
                _samplers[node + " " + target.path] = addSampler(new GltfSampler(file, sampler, place + ".samplers[" + number + "]", target.path));
            }
        }

        private function addSampler(sampler:GltfSampler):GltfSampler
        {
            add(sampler);
            return sampler;
        }

        /** The time of the last key, in seconds. 0 without keys. */
        public function get duration():Number
        {
            var most:Number = 0;
            for each (var sampler:GltfSampler in _samplers)
            {
                most = Math.max(most, sampler.end);
            }
            return most;
        }

        /** Sets the time, in seconds. */
        public function setTime(time:Number):void
        {
            for (var key:String in _samplers)
            {
                _values[key] = GltfSampler(_samplers[key]).valueAt(time);
            }
        }

        /** The numbers that a property of a node has at this time; null if it is not animated. */
        internal function valueOf(node:int, path:String):Vector.<Number>
        {
            return _values[node + " " + path];
        }
    }
}
