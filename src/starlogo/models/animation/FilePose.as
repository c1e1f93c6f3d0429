package starlogo.models.animation
{
    /**
     * What moves in a file: an animation at a time, or nothing. Readers ask it for the numbers that count in place of those in the file.
     *
     * @private
     */
    public final class FilePose
    {
        private var _animation:FileAnimation;
        private var _time:Number;

        // The numbers that were asked for, by target. A scene may ask for the same numbers often, because it may place a thing often.
        private var _numbers:Object = {};

        /**
         * @param animation the animation; null if nothing moves
         * @param time the time, in the animation's own time
         */
        public function FilePose(animation:FileAnimation = null, time:Number = 0)
        {
            _animation = animation;
            _time = time;
        }

        /** Whether nothing moves. */
        public function get isAtRest():Boolean
        {
            return _animation == null;
        }

        /** The numbers of a target; null if they are those in the file. @param target see <code>FileAnimation.numbersAt()</code> */
        public function numbersOf(target:Object):Vector.<Number>
        {
            if (!isAtRest && !(target in _numbers))
            {
                _numbers[target] = _animation.numbersAt(target, _time);
            }
            return _numbers[target];
        }
    }
}
