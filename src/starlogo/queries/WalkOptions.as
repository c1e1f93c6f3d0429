package starlogo.queries
{
    /** How an agent walks. A number that is refused leaves what was there. */
    public final class WalkOptions
    {
        private var _stepHeight:Number = 0.25;
        private var _slopeDegrees:Number = 45;
        private var _snap:Number = 0.25;

        /** Which agents are in the way and can be stood on; null for all. */
        public var filter:AgentFilter = null;

        /** For agents that are about a patch wide. */
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
            _stepHeight = checked("stepHeight", value);
        }

        /**
         * How steep the ground may be that it stands on and climbs, in degrees: 0 for level ground, less than 90. What is steeper is a wall.
         *
         * @throws RangeError if it is negative, 90 or more, or not a number
         */
        public function get slopeDegrees():Number
        {
            return _slopeDegrees;
        }

        public function set slopeDegrees(value:Number):void
        {
            if (!(value < 90))
            {
                throw new RangeError("slopeDegrees must be less than 90: " + value);
            }
            _slopeDegrees = checked("slopeDegrees", value);
        }

        /**
         * How far below it the ground may be, in patches, for it to stay on the ground, as it goes downhill and down steps. Where the ground is deeper it
         * walks into the air. 0 for ground that it touches.
         *
         * @throws RangeError if it is negative or not finite
         */
        public function get snap():Number
        {
            return _snap;
        }

        public function set snap(value:Number):void
        {
            _snap = checked("snap", value);
        }

        private static function checked(name:String, value:Number):Number
        {
            if (!(value >= 0 && value < Infinity))
            {
                throw new RangeError(name + " must not be negative, and finite: " + value);
            }
            return value;
        }
    }
}
