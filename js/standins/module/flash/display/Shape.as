package flash.display
{
    import flash.events.EventDispatcher;

    /** Stands in for a display object that is not drawn, but gets frame events. */
    public class Shape extends EventDispatcher
    {
    }
}
