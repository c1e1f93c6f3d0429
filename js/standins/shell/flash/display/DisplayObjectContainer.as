package flash.display
{
    import flash.events.Event;

    /** A container. It tells its children when they are added to the stage or removed from it. */
    public class DisplayObjectContainer extends DisplayObject
    {
        public var mouseChildren:Boolean = true;

        private var _children:Array = [];

        public function get numChildren():int
        {
            return _children.length;
        }

        public function getChildAt(index:int):DisplayObject
        {
            return _children[index];
        }

        public function addChild(child:DisplayObject):DisplayObject
        {
            if (child.parent != null)
            {
                child.parent.removeChild(child);
            }
            _children.push(child);
            child.container = this;
            if (stage != null)
            {
                child.tell(Event.ADDED_TO_STAGE);
            }
            return child;
        }

        /** @throws ArgumentError if the object is no child of this one */
        public function removeChild(child:DisplayObject):DisplayObject
        {
            var index:int = _children.indexOf(child);
            if (index < 0)
            {
                throw new ArgumentError("Error #2025: The supplied DisplayObject must be a child of the caller.");
            }
            if (stage != null)
            {
                child.tell(Event.REMOVED_FROM_STAGE);
            }
            _children.splice(index, 1);
            child.container = null;
            return child;
        }

        override internal function tell(type:String):void
        {
            super.tell(type);
            for each (var child:DisplayObject in _children.concat())
            {
                child.tell(type);
            }
        }
    }
}
