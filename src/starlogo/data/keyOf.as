package starlogo.data
{
    /**
     * The key under which an Object may keep something that has a name. It is no property that every Object has, whatever the name is: a model may be
     * called "hasOwnProperty". The key without its first character is the name.
     *
     * @private
     */
    public function keyOf(name:String):String
    {
        return "#" + name;
    }
}
