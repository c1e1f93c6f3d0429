package starlogo.models
{
    /**
     * An object's own value under a name; null if it has none. Names such as "hasOwnProperty" or "toString" are safe.
     *
     * @private
     */
    public function entryOf(owner:Object, name:String):Object
    {
        for (var key:String in owner)
        {
            if (key == name)
            {
                return owner[key];
            }
        }
        return null;
    }
}
