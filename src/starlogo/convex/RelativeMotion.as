package starlogo.convex
{
    import starlogo.geometry.Touching;

    /**
     * The straight motion of one shape past another that stands still, from time 0 to time 1, without rotation or growth, as a record. If both
     * move, it is the first shape's motion minus the second's.
     *
     * <p>Its <code>time</code> says where on it the shape is. All <code>findTimeOfImpact()</code> of kernels and queries of trees and the ground read the
     * vectors and the latest time. They move the time to when the two first touch, if that is no later. All <code>findContact()</code> read the
     * vectors and the time. Quick tests take it for the vector from time 0 to 1, and for the latest time if they need one, because V8 makes objects
     * of Numbers that are arguments.</p>
     *
     * @private
     */
    public final class RelativeMotion
    {
        /** The time of impact of shapes that do not touch in the part of the motion that is asked about. */
        public static const NEVER:Number = Infinity;

        /** The motion of a shape that stands still, at time 0. It must not be changed. */
        public static const NONE:RelativeMotion = new RelativeMotion(0);

        /** The vector from the shape's stored place to its place at time 0. */
        public var startX:Number = 0;
        public var startY:Number = 0;
        public var startZ:Number = 0;

        /** The vector from the shape's place at time 0 to its place at time 1. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The shapes are known not to touch before. ConvexKernel alone reads it and begins there; all other tests begin at 0. */
        public var earliestTime:Number = 0;

        /** Where the part of the motion that is asked about ends, from 0 to 1. No answer is later. */
        public var latestTime:Number = 1;

        /** The time at which the shape is on the motion. NEVER after a <code>findTimeOfImpact()</code> of two that do not touch. */
        public var time:Number;

        public function RelativeMotion(time:Number = NEVER)
        {
            this.time = time;
        }

        /** The margins of both vectors: see Touching. */
        public function get margin():Number
        {
            return Touching.marginOfMotion(startX, startY, startZ) + Touching.marginOfMotion(x, y, z);
        }

        /** Whether the shape does not move. */
        public function get isStill():Boolean
        {
            return x == 0 && y == 0 && z == 0;
        }

        /** Copies the vector from time 0 to time 1 of another motion. All else stays. */
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
            earliestTime = motion.earliestTime;
            latestTime = motion.latestTime;
        }
    }
}
