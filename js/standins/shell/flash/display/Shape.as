package flash.display
{
    /** Would draw. Frames come to it. */
    public class Shape extends DisplayObject
    {
    }
}
