package flash.system
{
    import standin.Machine;

    /** The memory in use. */
    public final class System
    {
        public static function get totalMemory():uint
        {
            return Machine.memory();
        }
    }
}
