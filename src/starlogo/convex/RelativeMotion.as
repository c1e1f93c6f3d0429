package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * A sweep of one shape against another that stands still, as a record: the straight motion from time 0 to time 1, without rotation or
     * growth, and a moment of it. If both move, it is the first shape's motion minus the second's.
     *
     * <p>The moment says how far the shape has come: <code>time</code>. A test that finds when two shapes first touch moves it to that moment, and a
     * contact is found there.</p>
     *
     * <p>Whoever asks when two shapes first touch may set <code>earliest</code> and <code>latest</code>. They only spare work, and each test may use
     * or ignore them. So if the shapes first touch after the latest time, a test gives that time or NEVER.</p>
     *
     * @private
     */
    public final class RelativeMotion
    {
        /** The time of impact of shapes that do not touch. */
        public static const NEVER:Number = Infinity;

        /** The motion of a shape that stands still, at time 0. Nobody changes it, but for its margin, which is 0. */
        public static const NONE:RelativeMotion = new RelativeMotion(0);

        /** The vector from the shape's stored place to its place at time 0. */
        public var startX:Number = 0;
        public var startY:Number = 0;
        public var startZ:Number = 0;

        /** The vector from the shape's place at time 0 to its place at time 1. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The moment, from 0 to 1. A test of when two shapes first touch sets it to NEVER if they do not. */
        public var time:Number;

        /** A time before which the shapes are known not to touch; 0 if none is known. */
        public var earliest:Number = 0;

        /** The latest time of impact that whoever asks needs, from 0 to 1. */
        public var latest:Number = 1;

        /** The margin of the motion (see Touching): its rounding error. Set by <code>findMargin()</code>. */
        public var margin:Number = 0;

        public function RelativeMotion(time:Number = NEVER)
        {
            this.time = time;
        }

        /** Whether the shape does not move. */
        public function get isStill():Boolean
        {
            return x == 0 && y == 0 && z == 0;
        }

        /** Copies the vector of another motion. The start and the times stay. */
        public function copyVector(other:RelativeMotion):void
        {
            x = other.x;
            y = other.y;
            z = other.z;
        }

        /** Sets a motion that ends at the shape's stored place, at time 1. */
        public function endAfter(x:Number, y:Number, z:Number):void
        {
            this.x = x;
            this.y = y;
            this.z = z;
            startX = -x;
            startY = -y;
            startZ = -z;
        }

        /** Makes this the motion of the other shape while the first one stands still, with the same time. */
        public function setReversed(motion:RelativeMotion):void
        {
            x = -motion.x;
            y = -motion.y;
            z = -motion.z;
            startX = -motion.startX;
            startY = -motion.startY;
            startZ = -motion.startZ;
            time = motion.time;
            earliest = motion.earliest;
            latest = motion.latest;
        }

        /** Computes the margin. */
        public function findMargin():void
        {
            // Touching.marginOfMotion() of both vectors, written out: this is asked for each triangle, and V8 makes objects of Numbers that are passed
            var start:Number = startX < 0 ? -startX : startX;
            start = startY < 0 ? start - startY : start + startY;
            start = startZ < 0 ? start - startZ : start + startZ;
            var travel:Number = x < 0 ? -x : x;
            travel = y < 0 ? travel - y : travel + y;
            travel = z < 0 ? travel - z : travel + z;
            margin = Tolerances.ROUNDING * start + Tolerances.ROUNDING * travel;
        }
    }
}
