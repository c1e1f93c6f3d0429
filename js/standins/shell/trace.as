package
{
    /** Prints a line. The shell uses its own function. This one is for the compiler. */
    public function trace(...values):void
    {
    }
}
