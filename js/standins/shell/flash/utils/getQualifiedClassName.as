package flash.utils
{
    import standin.Machine;

    /** The name of a value's class: package::Class. */
    public function getQualifiedClassName(value:*):String
    {
        return Machine.className(value);
    }
}
