package starlogo.intersection.sweep
{
    /**
     * When a point that passes another comes as near as a distance: where its line enters the sphere of that radius, in closed form.
     *
     * @private
     */
    public final class PointSweep
    {
        /** From the other to where the point is at time 0. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        /** The distance. */
        public var reach:Number = 0;

        /** At the other. */
        public function PointSweep()
        {
        }

        /**
         * Finds the time.
         *
         * @param motion of the point, from time 0 to time 1; takes the time, from 0 to 1, or RelativeMotion.NEVER
         */
        public function findTime(motion:RelativeMotion):void
        {
            var atX:Number = x;
            var atY:Number = y;
            var atZ:Number = z;
            var squared:Number = reach * reach;
            if (atX * atX + atY * atY + atZ * atZ <= squared)
            {
                motion.time = 0;
                return;
            }
            motion.time = RelativeMotion.NEVER;
            var motionX:Number = motion.x;
            var motionY:Number = motion.y;
            var motionZ:Number = motion.z;
            var closing:Number = -(atX * motionX + atY * motionY + atZ * motionZ);
            if (!(closing > 0))
            {
                return;
            }
            // from the point of the line that is nearest, as far back as half the chord
            var motionSquared:Number = motionX * motionX + motionY * motionY + motionZ * motionZ;
            var nearest:Number = closing / motionSquared;
            atX += nearest * motionX;
            atY += nearest * motionY;
            atZ += nearest * motionZ;
            var half:Number = squared - (atX * atX + atY * atY + atZ * atZ);
            if (half < 0)
            {
                return;
            }
            var time:Number = nearest - Math.sqrt(half / motionSquared);
            if (time <= 1)
            {
                motion.time = time > 0 ? time : 0;
            }
        }
    }
}
