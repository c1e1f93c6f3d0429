package starlogo.data
{
    /**
     * What an error message adds about a name that is not known: the name that is probably meant. In ActionScript it is nothing. The ES module
     * has its own version.
     *
     * @param name the name that is not known
     * @param names all names that are
     * @private
     */
    public function meantOf(name:String, names:Vector.<String>):String
    {
        return "";
    }
}
