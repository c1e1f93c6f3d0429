package starlogo.search
{
    /**
     * What errors call a thing that may be of any class: where there are no types, in the ES module, which has its own of these.
     *
     * @private
     */
    public function textOf(value:Object):String
    {
        return String(value);
    }
}
