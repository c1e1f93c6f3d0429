package starlogo.models.animation
{
    /**
     * The numbers that count in place of those in a file, at a time of its animation. They belong to targets. A target is a key for a thing in the
     * file that an animation may move, as the reader of the format says.
     *
     * @private
     */
    public final class Pose
    {
        private var _numbers:Object = {};

        /** All numbers of a target; null if they are those in the file. */
        public function numbersOf(target:String):Vector.<Number>
        {
            return _numbers[target];
        }

        /**
         * Sets some numbers of a target.
         *
         * @param inFile all numbers of the target, as they are in the file; null if all are set
         * @param first the index of the first one that is set
         * @param values the new numbers; kept if all are set
         */
        public function setNumbers(target:String, inFile:Vector.<Number>, first:int, values:Vector.<Number>):void
        {
            var numbers:Vector.<Number> = _numbers[target] ||= inFile == null ? values : inFile.slice();
            for (var i:int = 0; i < values.length; i++)
            {
                numbers[first + i] = values[i];
            }
        }
    }
}
