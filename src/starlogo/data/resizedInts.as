package starlogo.data
{
    /**
     * A copy of a list that zeroedInts() made, with another length. What is longer ends with zeros.
     *
     * @private
     */
    public function resizedInts(list:Vector.<int>, length:int):Vector.<int>
    {
        if (length <= list.length)
        {
            return list.slice(0, length);
        }
        var longer:Vector.<int> = zeroedInts(length);
        for (var i:int = 0; i < list.length; i++)
        {
            longer[i] = list[i];
        }
        return longer;
    }
}
