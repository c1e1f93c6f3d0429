package flash.utils
{
    import standin.Machine;

    /** What a value, or a class, has. */
    public function describeType(value:*):XML
    {
        return Machine.describe(value);
    }
}
