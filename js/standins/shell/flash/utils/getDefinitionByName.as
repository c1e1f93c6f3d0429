package flash.utils
{
    import standin.Machine;

    /** The class of that name. */
    public function getDefinitionByName(name:String):Object
    {
        return Machine.definition(name);
    }
}
