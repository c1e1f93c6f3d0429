package starlogo.motion
{
    /** From when to when no axis that was tried separates two things that pass each other. */
    internal final class TouchingTimes
    {
        /** The first moment. */
        public var first:Number;

        /** The last moment. */
        public var last:Number;

        /** No time yet. */
        public function TouchingTimes()
        {
        }

        /** Begins with no axis tried. */
        public function begin(latest:Number):void
        {
            first = 0;
            last = latest;
        }

        /**
         * Tries an axis.
         *
         * @param at where on it the one's middle is, from the other's, at time 0
         * @param speed how far it moves along it till time 1
         * @param reach how far the two reach along it together
         * @return whether it separates them all the time
         */
        public function areSeparated(at:Number, speed:Number, reach:Number):Boolean
        {
            // mirrored, so that it comes nearer from below, or goes away upwards
            if (speed < 0)
            {
                speed = -speed;
                at = -at;
            }
            var time:Number;
            if (at < -reach)
            {
                // false where speed is 0
                time = (-reach - at) / speed;
                if (!(time <= last))
                {
                    return true;
                }
                if (time > first)
                {
                    first = time;
                }
            }
            else if (at > reach)
            {
                return true;
            }
            if (at + last * speed > reach)
            {
                time = (reach - at) / speed;
                if (time < first)
                {
                    return true;
                }
                if (time < last)
                {
                    last = time;
                }
            }
            return false;
        }
    }
}
