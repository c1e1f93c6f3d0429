package starlogo.data
{
    /**
     * A list of zeros whose length stays, for lists as long as a model. In JavaScript it is an Int32Array, which takes half the memory of a list and
     * is there at once. The list must not leave the engine.
     *
     * @private
     */
    public function zeroedInts(length:int):Vector.<int>
    {
        return new Vector.<int>(length, true);
    }
}
