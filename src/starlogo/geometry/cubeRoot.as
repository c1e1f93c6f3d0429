package starlogo.geometry
{
    /**
     * The cube root, by Newton's method. The result is the same in every player, to the last bit. Its error is below one unit in the last
     * place.
     *
     * @param value any number
     * @private
     */
    public function cubeRoot(value:Number):Number
    {
        if (value == 0 || !isFinite(value))
        {
            return value;
        }
        var mantissa:Number = value < 0 ? -value : value;
        var scale:Number = value < 0 ? -1 : 1;
        while (mantissa >= 8)
        {
            mantissa /= 8;
            scale *= 2;
        }
        while (mantissa < 1)
        {
            mantissa *= 8;
            scale /= 2;
        }
        // From above, each step doubles the number of correct bits.
        var root:Number = (mantissa + 5) / 5;
        for (var i:int = 0; i < 7; i++)
        {
            root -= (root * root * root - mantissa) / (3 * root * root);
        }
        return scale * root;
    }
}
