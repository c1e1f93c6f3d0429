package flash.display
{
    import flash.events.EventDispatcher;

    /** Stands in for a display object that nobody sees, but that frames come to. */
    public class Shape extends EventDispatcher
    {
    }
}
