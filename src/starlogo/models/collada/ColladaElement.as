package starlogo.models.collada
{
    import starlogo.models.TextTokens;

    /** An element of a COLLADA document. Its name and those of its attributes are without the prefix of a namespace. */
    internal final class ColladaElement
    {
        /** Its name. */
        public var name:String;

        /** The element that it is in; null for the root. */
        public var parent:ColladaElement;

        /** The elements in it. */
        public var children:Vector.<ColladaElement> = new Vector.<ColladaElement>();

        /** The pieces of its own text, which comments and elements may divide. */
        public var texts:Array = [];

        // by "@" and the name, which is never the name of a property that each Object has
        private var _attributes:Object = {};

        /**
         * @param name its name
         * @param parent the element that it is in, which gets it as a child; null for the root
         */
        public function ColladaElement(name:String, parent:ColladaElement)
        {
            this.name = name;
            this.parent = parent;
            if (parent != null)
            {
                parent.children.push(this);
            }
        }

        /** Its id; "" if it has none. */
        public function get id():String
        {
            return attribute("id");
        }

        /** The value of an attribute; "" if it is not there. */
        public function attribute(name:String):String
        {
            return _attributes["@" + name] || "";
        }

        /** Gives it an attribute. */
        public function setAttribute(name:String, value:String):void
        {
            _attributes["@" + name] = value;
        }

        /** The elements of a name in it. */
        public function childrenNamed(name:String):Vector.<ColladaElement>
        {
            var found:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            for each (var candidate:ColladaElement in children)
            {
                if (candidate.name == name)
                {
                    found.push(candidate);
                }
            }
            return found;
        }

        /** The first element of a name in it, or null. */
        public function child(name:String):ColladaElement
        {
            var found:Vector.<ColladaElement> = childrenNamed(name);
            return found.length > 0 ? found[0] : null;
        }

        /** The words of its own text. ColladaWords does the same in steps, for long texts. */
        public function get words():Array
        {
            return TextTokens.of(texts.join(" "));
        }

        /** The way to it from the root: names, with ids or, among several without, with numbers from 1. */
        public function toString():String
        {
            var places:Array = [];
            for (var element:ColladaElement = this; element.parent != null; element = element.parent)
            {
                places.unshift(element.place);
            }
            return places.length > 0 ? places.join("/") : name;
        }

        private function get place():String
        {
            var alike:Vector.<ColladaElement> = parent.childrenNamed(name);
            return name + (id != "" ? "#" + TextTokens.shorten(id) : (alike.length == 1 ? "" : "[" + (alike.indexOf(this) + 1) + "]"));
        }
    }
}
