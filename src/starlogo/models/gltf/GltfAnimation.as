package starlogo.models.gltf
{
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

        // The samplers, by the node's index, a space and the path.
        private var _samplers:Object = {};

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
                json.refuseIf(target == null, "expected a target", where);
                var node:int = json.reference(target, "node", where + ".target", "nodes");
                // the target of an extension
                if (node < 0 || PATHS.indexOf(target.path) < 0)
                {
                    continue;
                }
                json.refuseIf(json.entry("nodes", node).matrix !== undefined && target.path != "weights", "a node with a matrix can't be animated",
                        where + ".target");
                var number:int = json.whole(channel, "sampler", where, samplers.length - 1, -1);
                var sampler:Object = json.elementOf(samplers, number, place + ".samplers");
                var reader:GltfSampler = new GltfSampler(file, sampler, place + ".samplers[" + number + "]", target.path);
                _samplers[node + " " + target.path] = reader;
                add(reader);
            }
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

        /** The numbers of all animated properties at a time in seconds. <code>valueIn()</code> finds them. */
        public function valuesAt(time:Number):Object
        {
            var values:Object = {};
            for (var key:String in _samplers)
            {
                values[key] = GltfSampler(_samplers[key]).valueAt(time);
            }
            return values;
        }

        /** The numbers of a node's property. Null if it is not animated, or if there are no values. */
        internal static function valueIn(values:Object, node:int, path:String):Vector.<Number>
        {
            return values == null ? null : values[node + " " + path];
        }
    }
}
