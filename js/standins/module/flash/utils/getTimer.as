package flash.utils
{
    import standin.Machine;

    /** Milliseconds since some fixed moment, with fractions, because a frame may take less than one. */
    public function getTimer():Number
    {
        return Machine.now();
    }
}
