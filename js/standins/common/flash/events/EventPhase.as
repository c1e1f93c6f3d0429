package flash.events
{
    /** Where on its way to the target an event is. */
    public final class EventPhase
    {
        public static const CAPTURING_PHASE:uint = 1;
        public static const AT_TARGET:uint = 2;
        public static const BUBBLING_PHASE:uint = 3;
    }
}
