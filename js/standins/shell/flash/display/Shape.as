package flash.display
{
    /** A shape. It is not drawn, but it gets frame events. */
    public class Shape extends DisplayObject
    {
    }
}
