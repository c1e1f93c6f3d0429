package flash.utils
{
    import standin.Machine;

    /** The name of the class that a value's class extends. */
    public function getQualifiedSuperclassName(value:*):String
    {
        return Machine.superclassName(value);
    }
}
