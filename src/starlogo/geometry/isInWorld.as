package starlogo.geometry
{
    import starlogo.engine;

    use namespace engine;

    /**
     * Whether three numbers are in the world: between -Agent.LARGEST_COORDINATE and Agent.LARGEST_COORDINATE. No NaN is.
     *
     * @param x a coordinate; y and z are others, or 0
     * @private
     */
    public function isInWorld(x:Number, y:Number, z:Number):Boolean
    {
        var most:Number = Placement.LARGEST_COORDINATE;
        return x >= -most && x <= most && y >= -most && y <= most && z >= -most && z <= most;
    }
}
