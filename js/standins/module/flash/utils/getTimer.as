package flash.utils
{
    import standin.Machine;

    /** Milliseconds since some moment, with fractions: a frame takes less than one. */
    public function getTimer():Number
    {
        return Machine.now();
    }
}
