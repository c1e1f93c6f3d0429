package starlogo.models.gltf
{
    /**
     * A time of an animation, or no animation: the pose in which a file is read.
     *
     * @private
     */
    public final class GltfPose
    {
        private var _animation:GltfAnimation;
        private var _time:Number;

        /**
         * @param animation null for the rest pose
         * @param time in seconds
         */
        public function GltfPose(animation:GltfAnimation = null, time:Number = 0)
        {
            _animation = animation;
            _time = time;
        }

        /** The numbers of a node's property in this pose; null if it is not animated. */
        internal function valueOf(node:int, path:String):Vector.<Number>
        {
            return _animation == null ? null : _animation.valueAt(node, path, _time);
        }
    }
}
