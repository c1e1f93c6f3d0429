package starlogo.models.animation
{
    /**
     * A channel of an animation: numbers of the file that move, and the sampler that moves them.
     *
     * @private
     */
    public final class AnimationChannel
    {
        /** Moves the numbers. Read only. */
        public var sampler:AnimationSampler;

        private var _target:String;
        private var _inFile:Vector.<Number>;
        private var _first:int;

        /**
         * @param sampler moves the numbers
         * @param target the thing in the file whose numbers move
         * @param inFile all numbers of the target, as they are in the file; null if all move
         * @param first the index of the first one that moves
         */
        public function AnimationChannel(sampler:AnimationSampler, target:String, inFile:Vector.<Number> = null, first:int = 0)
        {
            this.sampler = sampler;
            _target = target;
            _inFile = inFile;
            _first = first;
        }

        /** Sets the numbers of a pose to those at a time. @param time seconds */
        public function applyTo(pose:Pose, time:Number):void
        {
            pose.setNumbers(_target, _inFile, _first, sampler.numbersAt(time));
        }
    }
}
