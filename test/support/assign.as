package support
{
    /** Sets a property, for <code>assertThrows</code>. */
    public function assign(object:Object, name:String, value:*):void
    {
        object[name] = value;
    }
}
