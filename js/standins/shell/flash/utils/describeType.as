package flash.utils
{
    import standin.Machine;

    /** A description of the members of a value or a class. */
    public function describeType(value:*):XML
    {
        return Machine.describe(value);
    }
}
