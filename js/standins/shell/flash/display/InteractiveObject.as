package flash.display
{
    /** What would take input. */
    public class InteractiveObject extends DisplayObject
    {
        public var mouseEnabled:Boolean = true;
        public var doubleClickEnabled:Boolean = false;
        public var tabEnabled:Boolean = false;
        public var tabIndex:int = -1;
    }
}
