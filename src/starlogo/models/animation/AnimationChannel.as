package starlogo.models.animation
{
    /**
     * A channel of an animation: numbers of the file that move, and the sampler that moves them. The numbers belong to a target, which is a key for a
     * thing in the file that an animation may move, as the reader of the format says.
     *
     * @private
     */
    public final class AnimationChannel
    {
        /** Moves the numbers. Read only. */
        public var sampler:AnimationSampler;

        private var _target:String;
        private var _rest:Vector.<Number>;
        private var _first:int;

        /**
         * @param sampler moves the numbers
         * @param target has the numbers
         * @param rest all numbers of the target at rest, as in the file; null if all of them move
         * @param first the index of the first one that moves
         */
        public function AnimationChannel(sampler:AnimationSampler, target:String, rest:Vector.<Number> = null, first:int = 0)
        {
            this.sampler = sampler;
            _target = target;
            _rest = rest;
            _first = first;
        }

        /**
         * Sets the numbers of a pose to those at a time.
         *
         * @param pose takes all numbers of the target, by the target
         * @param time seconds
         */
        public function applyTo(pose:Object, time:Number):void
        {
            var values:Vector.<Number> = sampler.numbersAt(time);
            var numbers:Vector.<Number> = pose[_target] ||= _rest == null ? values : _rest.slice();
            for (var i:int = 0; i < values.length; i++)
            {
                numbers[_first + i] = values[i];
            }
        }
    }
}
