package flash.utils
{
    import standin.Machine;

    /** The class with a name. */
    public function getDefinitionByName(name:String):Object
    {
        return Machine.definition(name);
    }
}
