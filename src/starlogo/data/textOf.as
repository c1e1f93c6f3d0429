package starlogo.data
{
    /**
     * The text that an error message uses for an object of any class. A string stands in quotes. JavaScript callers can pass such objects,
     * because they have no types. The ES module has its own version of this function.
     *
     * @param wanted the type that was expected, for example "an Agent"
     *
     * @private
     */
    public function textOf(value:Object, wanted:String = null):String
    {
        return value is String ? "\"" + value + "\"" : String(value);
    }
}
