package starlogo.data
{
    /**
     * A key of an Object for any name, because a model may be called "hasOwnProperty". The key without its first character is the name.
     *
     * @private
     */
    public function keyOf(name:String):String
    {
        return "#" + name;
    }
}
