package starlogo.data
{
    /**
     * A list of zeros whose length stays, for lists as long as a model. In JavaScript it is a Float64Array, which is there at once. The list must not
     * leave the engine.
     *
     * @private
     */
    public function zeroedNumbers(length:int):Vector.<Number>
    {
        return new Vector.<Number>(length, true);
    }
}
