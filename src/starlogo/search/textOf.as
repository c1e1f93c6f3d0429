package starlogo.search
{
    /**
     * What errors call a thing that may be of any class: where there are no types, in the ES module, which has its own of these.
     *
     * @param wanted what the thing has to be: "an Agent", say
     *
     * @private
     */
    public function textOf(value:Object, wanted:String = null):String
    {
        return String(value);
    }
}
