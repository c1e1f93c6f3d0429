package flash.utils
{
    import standin.Machine;

    /** Takes back what setTimeout promised. */
    public function clearTimeout(id:uint):void
    {
        Machine.clearTimeout(id);
    }
}
