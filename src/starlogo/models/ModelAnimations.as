package starlogo.models
{
    import starlogo.models.animation.FileAnimation;

    /**
     * The animations of a file, as poses of the model of the same file. <code>GltfAnimations</code> and <code>ColladaAnimations</code> read them.
     *
     * <p><code>model.pose(animations.verticesAt(0, seconds % animations.durationOf(0)))</code> plays the first one again and again. If it has one key
     * only, it has no duration: ask for <code>verticesAt(0, 0)</code>.</p>
     */
    public class ModelAnimations
    {
        private var _animations:Vector.<FileAnimation>;

        /**
         * Use the classes that read a format.
         *
         * @param animations the animations; makes a pose of the first one, so that what moves is read and checked
         *
         * @private
         */
        public function ModelAnimations(animations:Vector.<FileAnimation>)
        {
            _animations = animations;
            if (animations.length > 0)
            {
                animations[0].verticesAt(0);
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
         * The length of an animation in seconds: from time 0 to its last key, or to the end that a COLLADA clip names. It may be 0.
         *
         * @param animation its index
         * @throws RangeError if there is no such animation
         */
        public function durationOf(animation:int):Number
        {
            return animationOf(animation).duration;
        }

        /**
         * The vertices at a time of an animation, in the coordinates of the model's source, for <code>Model.pose()</code>. Cost: that of
         * placing the scene's meshes, which are read once.
         *
         * @param animation its index
         * @param time seconds; it counts as 0 if it is less, and as the duration if it is more. Before the first key, nothing moves
         * @return x, y, z of each vertex, in the order of the model's vertices; a new vector
         * @throws RangeError if there is no such animation, or the time is not finite
         * @throws ModelError if the meshes are wrong, or a coordinate is not finite at this time
         */
        public function verticesAt(animation:int, time:Number):Vector.<Number>
        {
            var found:FileAnimation = animationOf(animation);
            if (!isFinite(time))
            {
                throw new RangeError("the time must be a finite number, not " + time);
            }
            return found.verticesAt(time);
        }

        private function animationOf(animation:int):FileAnimation
        {
            if (animation < 0 || animation >= _animations.length)
            {
                throw new RangeError(_animations.length == 0 ? "the file has no animations" : "the file has animations 0 to " + (_animations.length - 1) + ", not " + animation);
            }
            return _animations[animation];
        }
    }
}
