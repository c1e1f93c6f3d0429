package starlogo.models.animation
{
    /**
     * Makes the length of a quaternion 1, unless it is 0 or infinite.
     *
     * @private
     */
    public function normaliseQuaternion(turn:Vector.<Number>):void
    {
        var length:Number = Math.sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3]);
        for (var i:int = 0; i < 4 && length > 0 && length < Infinity; i++)
        {
            turn[i] /= length;
        }
    }
}
