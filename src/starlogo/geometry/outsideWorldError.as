package starlogo.geometry
{
    import starlogo.engine;

    use namespace engine;

    /** The error that <code>requireInWorld()</code> throws. The parameters are the same. @private */
    public function outsideWorldError(what:String, x:Number, y:Number, z:Number, owner:Object):RangeError
    {
        var most:Number = Placement.LARGEST_COORDINATE;
        // the largest one, because an infinite coordinate of a structure makes others NaN
        var wrong:Number = NaN;
        for each (var value:Number in [x, y, z])
        {
            wrong = Math.abs(value) > most && !(Math.abs(value) <= Math.abs(wrong)) ? value : wrong;
        }
        return new RangeError((owner == null ? "" : owner + ": ") + what + " must be a finite number between " + -most + " and " + most + ", not " + wrong);
    }
}
