package starlogo.models
{
    /**
     * What an object has of its own under a name; null if it has nothing there. The name may be any text, as "hasOwnProperty" or "toString".
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
