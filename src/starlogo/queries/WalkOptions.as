package starlogo.queries
{
    /** How an agent walks. If a property refuses a number, it keeps its old value. */
    public final class WalkOptions
    {
        private var _stepHeight:Number = 0.25;
        private var _slopeDegrees:Number = 45;
        private var _snap:Number = 0.25;
        private var _fall:Number = 0.5;

        /** The agents that can be in its way, and that it can stand on; null for all. */
        public var filter:AgentFilter = null;

        /** Begins with options for agents that are about a patch wide. */
        public function WalkOptions()
        {
        }

        /** The greatest height of a step that it climbs, in patches. 0 for none. @throws RangeError if it is negative or not finite */
        public function get stepHeight():Number
        {
            return _stepHeight;
        }

        public function set stepHeight(value:Number):void
        {
            _stepHeight = checked("stepHeight", value, Infinity);
        }

        /**
         * The steepest slope that it can stand on and climb, in degrees, from 0 to less than 90. With 0 it can stand only on level ground.
         * A steeper surface is a wall.
         *
         * @throws RangeError if it is negative, 90 or more, or not a number
         */
        public function get slopeDegrees():Number
        {
            return _slopeDegrees;
        }

        public function set slopeDegrees(value:Number):void
        {
            _slopeDegrees = checked("slopeDegrees", value, 90);
        }

        /**
         * The greatest depth of the ground below it, in patches, at which it stays on the ground. So it can go downhill and down steps. If
         * the ground is deeper, it falls. With 0 it stays only on ground that it touches.
         *
         * @throws RangeError if it is negative or not finite
         */
        public function get snap():Number
        {
            return _snap;
        }

        public function set snap(value:Number):void
        {
            _snap = checked("snap", value, Infinity);
        }

        /**
         * How far the agent falls in one walk if it does not stand on anything, in patches. With Infinity it lands at once. With 0 it does
         * not fall, so that a game can have gravity of its own.
         *
         * @throws RangeError if it is negative or not a number
         */
        public function get fall():Number
        {
            return _fall;
        }

        public function set fall(value:Number):void
        {
            _fall = value == Infinity ? value : checked("fall", value, Infinity);
        }

        private static function checked(name:String, value:Number, limit:Number):Number
        {
            if (!(value >= 0 && value < limit))
            {
                throw new RangeError(name + " must be at least 0, and less than " + limit + ": " + value);
            }
            return value;
        }
    }
}
