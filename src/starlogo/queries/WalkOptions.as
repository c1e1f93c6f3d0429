package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /** How an agent walks. If a property refuses a number, it keeps its old value. */
    public final class WalkOptions
    {
        private var _stepHeight:Number = 0.25;
        private var _slopeDegrees:Number = 45;
        private var _snap:Number = 0.25;
        private var _fall:Number = 0.5;

        /** The agents that can be in its way, and that it can stand on; null for all. Breeds of it need <code>Collision.TERRAIN</code> for the ground. */
        public var filter:AgentFilter = null;

        /**
         * Whether the agent is carried by the agent that it stands on: moved and turned about the z axis, as that one has moved and turned since
         * the last walk.
         */
        public var carried:Boolean = true;

        /** Begins with options for agents that are about a patch wide. */
        public function WalkOptions()
        {
        }

        /**
         * The greatest height of a step that it climbs, in patches. 0.25 at first; 0 for none. A box keeps to it exactly. A round foot, such as
         * a capsule's, goes over an edge as up a slope, so it climbs up to (1 - cos <code>slopeDegrees</code>) of its radius more. For a strict
         * limit take a box, or less of <code>slopeDegrees</code>.
         *
         * @throws RangeError if it is negative, above 1e9 or not a number
         */
        public function get stepHeight():Number
        {
            return _stepHeight;
        }

        public function set stepHeight(value:Number):void
        {
            _stepHeight = checked("stepHeight", value);
        }

        /**
         * The steepest slope that it can stand on and climb, in degrees, from 0 to less than 90; 45 at first. With 0 it can stand only
         * on level ground. A steeper surface is a wall.
         *
         * @throws RangeError if it is negative, 90 or more, or not a number
         */
        public function get slopeDegrees():Number
        {
            return _slopeDegrees;
        }

        public function set slopeDegrees(value:Number):void
        {
            if (!(value >= 0 && value < 90))
            {
                throw new RangeError("slopeDegrees must be at least 0, and less than 90: " + value);
            }
            _slopeDegrees = value;
        }

        /**
         * The greatest depth of the ground below it, in patches, at which it stays on the ground; 0.25 at first. So it can go downhill and down
         * steps. After a way up, for example over the upper end of a ramp, the depth below where this way began counts. If the ground is deeper,
         * it falls. With 0 it stays only on ground that it touches.
         *
         * @throws RangeError if it is negative, above 1e9 or not a number
         */
        public function get snap():Number
        {
            return _snap;
        }

        public function set snap(value:Number):void
        {
            _snap = checked("snap", value);
        }

        /**
         * How far the agent falls in one walk if it does not stand on anything, in patches; 0.5 at first. With Infinity it lands at
         * once; if there is nothing below it, it stays where it is. With 0 it does not fall, so that a game can have gravity of its own.
         *
         * @throws RangeError if it is negative, not a number, or above 1e9 but not Infinity
         */
        public function get fall():Number
        {
            return _fall;
        }

        public function set fall(value:Number):void
        {
            _fall = value == Infinity ? value : checked("fall (if it is not Infinity)", value);
        }

        /** @private Becomes a copy of other options. */
        engine function copyFrom(other:WalkOptions):void
        {
            _stepHeight = other.stepHeight;
            _slopeDegrees = other.slopeDegrees;
            _snap = other.snap;
            _fall = other.fall;
            filter = other.filter;
            carried = other.carried;
        }

        private static function checked(name:String, value:Number):Number
        {
            if (!(value >= 0 && value <= Agent.LARGEST_COORDINATE))
            {
                throw new RangeError(name + " must be between 0 and " + Agent.LARGEST_COORDINATE + ", not " + value);
            }
            return value;
        }
    }
}
