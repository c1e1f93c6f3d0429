package starlogo.data
{
    /**
     * A copy of a list that zeroedNumbers() made, with another length. What is longer ends with zeros.
     *
     * @private
     */
    public function resizedNumbers(list:Vector.<Number>, length:int):Vector.<Number>
    {
        if (length <= list.length)
        {
            return list.slice(0, length);
        }
        var longer:Vector.<Number> = zeroedNumbers(length);
        for (var i:int = 0; i < list.length; i++)
        {
            longer[i] = list[i];
        }
        return longer;
    }
}
