package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.gltf.GltfFile;
    import starlogo.models.gltf.GltfAnimation;
    import starlogo.models.gltf.GltfReader;
    import starlogo.steps.finish;

    /**
     * The animations of a glTF file, as poses of the GltfModel of the same file:
     *
     * <listing version="3.0">model.pose(animations.verticesAt(0, seconds % animations.durationOf(0)));</listing>
     *
     * <p>Nodes that move, turn and scale, skins, and the weights of morph targets are animated, with linear, stepped and cubic keys. What
     * extensions animate (KHR_animation_pointer) is ignored. An animation of a node with a matrix is refused. COLLADA's animations are not
     * read.</p>
     */
    public final class GltfAnimations
    {
        private var _file:GltfFile;
        private var _upAxis:Object;
        private var _animations:Vector.<GltfAnimation> = new Vector.<GltfAnimation>();

        /**
         * Reads the animations of a file.
         *
         * @param name the model's name, for errors
         * @param bytes the whole file; its position and endianness may change
         * @param upAxis the same as for the GltfModel
         * @param buffers the same as for the GltfModel
         * @throws ModelError as GltfModel, or if an animation is wrong
         */
        public function GltfAnimations(name:String, bytes:ByteArray, upAxis:Object = null, buffers:Object = null)
        {
            _upAxis = upAxis;
            _file = GltfFile.of(name, bytes, buffers);
            for (var i:int = 0; i < _file.animationCount; i++)
            {
                var read:GltfAnimation = new GltfAnimation(_file, i);
                finish(read);
                _animations.push(read);
            }
        }

        /** The number of animations. */
        public function get count():int
        {
            return _animations.length;
        }

        /**
         * The index of the animation with a name; -1 if there is none.
         *
         * @param name as in the file
         */
        public function indexOf(name:String):int
        {
            for (var i:int = 0; i < _animations.length; i++)
            {
                if (_animations[i].name == name)
                {
                    return i;
                }
            }
            return -1;
        }

        /**
         * The time of an animation's last key, in seconds.
         *
         * @param animation its index
         * @throws RangeError if there is no such animation
         */
        public function durationOf(animation:int):Number
        {
            return animationOf(animation).duration;
        }

        /**
         * The vertices at a time of an animation, in the coordinates of the model's source, for <code>Model.pose()</code>. Cost: that of reading
         * the file's meshes, without the file itself.
         *
         * @param animation its index
         * @param time seconds. Before the first key and after the last one, nothing moves
         * @return x, y, z of each vertex, in the order of the GltfModel's vertices; a new vector
         * @throws RangeError if there is no such animation, or the time is not finite
         * @throws ModelError if the meshes are wrong, or a coordinate is not finite at this time
         */
        public function verticesAt(animation:int, time:Number):Vector.<Number>
        {
            var found:GltfAnimation = animationOf(animation);
            if (time - time != 0)
            {
                throw new RangeError("the time must be a finite number, not " + time);
            }
            return GltfReader.verticesAt(_file, _upAxis, found, time);
        }

        private function animationOf(animation:int):GltfAnimation
        {
            if (animation < 0 || animation >= _animations.length)
            {
                throw new RangeError("the file has animations 0 to " + (_animations.length - 1) + ", not " + animation);
            }
            return _animations[animation];
        }
    }
}
