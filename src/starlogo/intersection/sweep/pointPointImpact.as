package starlogo.intersection.sweep
{
    /**
     * When a point that passes another comes as near as a distance: where its line enters the sphere of that radius, in closed form.
     *
     * @param x from the other to where the point is at time 0
     * @param y likewise
     * @param z likewise
     * @param motionX from there to where it is at time 1
     * @param motionY likewise
     * @param motionZ likewise
     * @param reach the distance
     * @return from 0 to 1, or RelativeMotion.NEVER
     *
     * @private
     */
    public function pointPointImpact(x:Number, y:Number, z:Number, motionX:Number, motionY:Number, motionZ:Number, reach:Number):Number
    {
        reach *= reach;
        if (x * x + y * y + z * z <= reach)
        {
            return 0;
        }
        var closing:Number = -(x * motionX + y * motionY + z * motionZ);
        if (!(closing > 0))
        {
            return RelativeMotion.NEVER;
        }
        // from the point of the line that is nearest, as far back as half the chord
        var motionSquared:Number = motionX * motionX + motionY * motionY + motionZ * motionZ;
        var nearest:Number = closing / motionSquared;
        x += nearest * motionX;
        y += nearest * motionY;
        z += nearest * motionZ;
        var half:Number = reach - (x * x + y * y + z * z);
        if (half < 0)
        {
            return RelativeMotion.NEVER;
        }
        var time:Number = nearest - Math.sqrt(half / motionSquared);
        if (time > 1)
        {
            return RelativeMotion.NEVER;
        }
        return time > 0 ? time : 0;
    }
}
