package starlogo.intersection.sweep
{
    import starlogo.geometry.Tolerances;

    /**
     * How one structure moves while another stands still: along a straight line, from time 0 to time 1, neither turning nor growing.
     * Where both move, it is the motion of the first less that of the second. Plain fields, because the pair tests read them, and write their
     * result: of Numbers that are passed or returned V8 makes objects.
     *
     * @private
     */
    public final class RelativeMotion
    {
        /** The time of impact of structures that do not touch. */
        public static const NEVER:Number = Infinity;

        /** The motion of a structure that stands still. */
        public static const NONE:RelativeMotion = new RelativeMotion();

        private static const TURNED:RelativeMotion = new RelativeMotion();

        /** From where the structure stands to where it is at time 0. */
        public var startX:Number = 0;

        /** @copy #startX */
        public var startY:Number = 0;

        /** @copy #startX */
        public var startZ:Number = 0;

        /** From where it is at time 0 to where it is at time 1. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        /** When the structures touch for the first time that were asked about, from 0 to 1, or NEVER. What asks how they touch asks about then. */
        public var time:Number = NEVER;

        /** How much farther apart than standing structures those on this motion may be and still touch, as of <code>findRounding()</code>. */
        public var rounding:Number = 0;

        /** No motion. */
        public function RelativeMotion()
        {
        }

        /** Makes it the motion that has brought the structure to where it stands: that is its end. */
        public function endAfter(x:Number, y:Number, z:Number):void
        {
            this.x = x;
            this.y = y;
            this.z = z;
            startX = -x;
            startY = -y;
            startZ = -z;
        }

        /** Makes it a displacement: its start is where another motion is at its time. It has to be none otherwise. */
        public function stopAt(motion:RelativeMotion):void
        {
            var at:Number = motion.time;
            startX = motion.startX + at * motion.x;
            startY = motion.startY + at * motion.y;
            startZ = motion.startZ + at * motion.z;
        }

        /** Makes it the way back of another motion. */
        public function reverse(motion:RelativeMotion):void
        {
            startX = motion.startX + motion.x;
            startY = motion.startY + motion.y;
            startZ = motion.startZ + motion.z;
            x = -motion.x;
            y = -motion.y;
            z = -motion.z;
        }

        /** Makes it the motion of the other structure, while this one stands still, at the same time. */
        public function turn(motion:RelativeMotion):void
        {
            x = -motion.x;
            y = -motion.y;
            z = -motion.z;
            startX = -motion.startX;
            startY = -motion.startY;
            startZ = -motion.startZ;
            time = motion.time;
        }

        /** The motion of the other structure, while this one stands still; the next call overwrites it. */
        public static function turned(motion:RelativeMotion):RelativeMotion
        {
            TURNED.turn(motion);
            return TURNED;
        }

        /** Finds the rounding error of the motion. */
        public function findRounding():void
        {
            // not with Math.abs, which would be a call for each
            var sum:Number = startX < 0 ? -startX : startX;
            sum = startY < 0 ? sum - startY : sum + startY;
            sum = startZ < 0 ? sum - startZ : sum + startZ;
            sum = x < 0 ? sum - x : sum + x;
            sum = y < 0 ? sum - y : sum + y;
            sum = z < 0 ? sum - z : sum + z;
            rounding = Tolerances.ROUNDING * sum;
        }
    }
}
