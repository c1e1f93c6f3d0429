package
{
    /** Prints a line. The shell has it itself and takes its own: this is for the compiler. */
    public function trace(...values):void
    {
    }
}
