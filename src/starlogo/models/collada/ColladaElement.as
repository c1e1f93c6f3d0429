package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.text.TextWords;

    /** An element of a COLLADA document. Its name and its attributes' names have no namespace prefix. */
    internal final class ColladaElement
    {
        /** The element's name. */
        public var name:String;

        /** The element around this one; null for the root. */
        public var parent:ColladaElement;

        /** The elements directly inside. */
        public var children:Vector.<ColladaElement> = new Vector.<ColladaElement>();

        /** The pieces of the element's own text. Comments and elements may divide it. */
        public var texts:Array = [];

        /** For an element that is a transform: the transform, after a scene first needed it. */
        public var transform:AffineTransform = null;

        // the key is "@" and the name, which differs from every property that each Object has
        private var _attributes:Object = {};

        // The first child of each name, of each name and id, and the first input of each semantic. It is made when it is first needed.
        private var _first:Object = null;

        /**
         * @param name the element's name
         * @param parent the element around it, which takes it as a child; null for the root
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

        /** The element's id; "" if it has none. */
        public function get id():String
        {
            return attribute("id");
        }

        /** The value of an attribute; "" if there is none. */
        public function attribute(name:String):String
        {
            return _attributes["@" + name] || "";
        }

        /** Sets an attribute. */
        public function setAttribute(name:String, value:String):void
        {
            _attributes["@" + name] = value;
        }

        /** The child elements with a name. */
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

        /** The first child element with a name, or null. */
        public function child(name:String):ColladaElement
        {
            return first("<" + name);
        }

        /** The first child element with a name and an id, or null. */
        public function childWithId(name:String, id:String):ColladaElement
        {
            return first("<" + name + "#" + id);
        }

        /** The first child element "input" with a semantic, or null. */
        public function input(semantic:String):ColladaElement
        {
            return first("@" + semantic);
        }

        private function first(key:String):ColladaElement
        {
            if (_first == null)
            {
                _first = {};
                for each (var child:ColladaElement in children)
                {
                    var keys:Array = ["<" + child.name, "<" + child.name + "#" + child.id, child.name == "input" ? "@" + child.attribute("semantic") : ""];
                    for each (var each:String in keys)
                    {
                        _first[each] ||= child;
                    }
                }
            }
            return _first[key];
        }

        /** Splits the element's own text into words. For long texts, ColladaWords does the same in steps. */
        public function splitText():Array
        {
            return TextWords.of(texts.join(" "));
        }

        /** The path from the root: names, with ids. Elements without an id that have siblings of the same name get numbers from 1. */
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
            return name + (id != "" ? "#" + TextWords.shorten(id) : (alike.length == 1 ? "" : "[" + (alike.indexOf(this) + 1) + "]"));
        }
    }
}
