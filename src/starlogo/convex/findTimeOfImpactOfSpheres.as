package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * Finds when two spheres first touch, in closed form: the path of one centre enters a sphere around the other centre. The radius of that
     * sphere is the touch distance. The nearest point of the path comes first, so that no digits cancel when the path begins far away.
     *
     * @param gap the vector from the other centre to the moving one at time 0, and the touch distance
     * @param motion the motion of the one centre; its start is not used. Receives the time
     * @private
     */
    public function findTimeOfImpactOfSpheres(gap:BallGap, motion:RelativeMotion):void
    {
        var x:Number = gap.x;
        var y:Number = gap.y;
        var z:Number = gap.z;
        var squaredRadius:Number = gap.touchDistance;
        squaredRadius *= squaredRadius;
        if (x * x + y * y + z * z <= squaredRadius)
        {
            motion.time = 0;
            return;
        }
        motion.time = RelativeMotion.NEVER;
        var motionX:Number = motion.x;
        var motionY:Number = motion.y;
        var motionZ:Number = motion.z;
        var approach:Number = -(x * motionX + y * motionY + z * motionZ);
        if (!(approach > 0))
        {
            return;
        }
        // The line enters half a chord before its point that is nearest to the other centre.
        var squaredMotion:Number = motionX * motionX + motionY * motionY + motionZ * motionZ;
        var nearest:Number = approach / squaredMotion;
        x += nearest * motionX;
        y += nearest * motionY;
        z += nearest * motionZ;
        var squaredHalfChord:Number = squaredRadius - (x * x + y * y + z * z);
        if (squaredHalfChord < 0)
        {
            return;
        }
        var time:Number = nearest - Math.sqrt(squaredHalfChord / squaredMotion);
        // rounding must not hide a touch at the end
        if (time <= motion.latestTime + Tolerances.ROUNDING)
        {
            time = time < motion.latestTime ? time : motion.latestTime;
            motion.time = time > 0 ? time : 0;
        }
    }
}
