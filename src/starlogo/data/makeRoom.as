package starlogo.data
{
    /**
     * Makes a list at least this long. It grows by an eighth more, because a vector that grows a little each time is copied each time.
     *
     * @private
     */
    public function makeRoom(list:Vector.<int>, length:int):void
    {
        if (list.length < length)
        {
            list.length = length + (length >> 3);
        }
    }
}
