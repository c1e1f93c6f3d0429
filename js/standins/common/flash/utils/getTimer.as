package flash.utils
{
    import standin.Machine;

    /** Milliseconds since some fixed moment. */
    public function getTimer():int
    {
        return Machine.timer == null ? int(Machine.now()) : Machine.timer();
    }
}
