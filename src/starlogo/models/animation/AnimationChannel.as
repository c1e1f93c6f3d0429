package starlogo.models.animation
{
    /**
     * A channel of an animation: which numbers of the file move, and how.
     *
     * @private
     */
    public final class AnimationChannel
    {
        /** How the numbers move. Read only. */
        public var sampler:AnimationSampler;

        private var _target:String;
        private var _numbers:Vector.<Number>;
        private var _first:int;

        /**
         * @param target the thing in the file whose numbers move
         * @param sampler how they move
         * @param numbers all numbers of the target, as they are in the file
         * @param first the index of the first one that moves
         */
        public function AnimationChannel(target:String, sampler:AnimationSampler, numbers:Vector.<Number>, first:int = 0)
        {
            this.sampler = sampler;
            _target = target;
            _numbers = numbers;
            _first = first;
        }

        /** Sets the numbers of a pose to those at a time. @param time seconds */
        public function setPose(pose:Pose, time:Number):void
        {
            pose.setNumbers(_target, _numbers, _first, sampler.valueAt(time));
        }
    }
}
