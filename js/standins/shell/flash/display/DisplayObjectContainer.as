package flash.display
{
    import flash.events.Event;

    /** Has children, told when they come onto the stage and leave it. */
    public class DisplayObjectContainer extends InteractiveObject
    {
        public var mouseChildren:Boolean = true;
        public var tabChildren:Boolean = true;

        private var _children:Array = [];

        public function get numChildren():int
        {
            return _children.length;
        }

        public function addChild(child:DisplayObject):DisplayObject
        {
            return addChildAt(child, _children.length);
        }

        public function addChildAt(child:DisplayObject, index:int):DisplayObject
        {
            if (child.parent != null)
            {
                child.parent.removeChild(child);
            }
            _children.splice(index, 0, child);
            child.container = this;
            if (stage != null)
            {
                child.tell(Event.ADDED_TO_STAGE);
            }
            return child;
        }

        /** @throws ArgumentError if it is no child of this */
        public function removeChild(child:DisplayObject):DisplayObject
        {
            var index:int = getChildIndex(child);
            if (stage != null)
            {
                child.tell(Event.REMOVED_FROM_STAGE);
            }
            _children.splice(index, 1);
            child.container = null;
            return child;
        }

        public function removeChildAt(index:int):DisplayObject
        {
            return removeChild(getChildAt(index));
        }

        /** @throws RangeError if there is no such child */
        public function getChildAt(index:int):DisplayObject
        {
            if (index < 0 || index >= _children.length)
            {
                throw new RangeError("Error #2006: The supplied index is out of bounds.");
            }
            return _children[index];
        }

        /** @throws ArgumentError if it is no child of this */
        public function getChildIndex(child:DisplayObject):int
        {
            var index:int = _children.indexOf(child);
            if (index < 0)
            {
                throw new ArgumentError("Error #2025: The supplied DisplayObject must be a child of the caller.");
            }
            return index;
        }

        public function contains(child:DisplayObject):Boolean
        {
            while (child != null && child != this)
            {
                child = child.parent;
            }
            return child == this;
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
