package flash.utils
{
    import standin.Machine;

    /** Milliseconds since some moment. */
    public function getTimer():int
    {
        return int(Machine.now());
    }
}
