package starlogo.models.collada
{
    import starlogo.models.TextTokens;

    /**
     * An element of a COLLADA document, known by its name in any namespace. All use of E4X is in this class.
     *
     * <p>Names are compared as texts: players differ in what a QName of no namespace finds.</p>
     */
    internal final class ColladaElement
    {
        private var _xml:XML;
        private var _name:String;
        private var _children:Vector.<ColladaElement> = null;

        /**
         * @param xml the element
         */
        public function ColladaElement(xml:XML)
        {
            _xml = xml;
            _name = xml.localName();
        }

        /**
         * The root element of a document; null if there is none.
         *
         * @throws TypeError if it is not well-formed
         */
        internal static function parse(source:String):ColladaElement
        {
            var xml:XML = new XML(source);
            return xml.nodeKind() == "element" ? new ColladaElement(xml) : null;
        }

        /** Its name, without that of a namespace. */
        public function get name():String
        {
            return _name;
        }

        /** Its id; "" if it has none. */
        public function get id():String
        {
            return attribute("id");
        }

        /** The value of an attribute; "" if it is not there. */
        public function attribute(name:String):String
        {
            return _xml.attribute(name).toString();
        }

        /** The elements in it. */
        public function get children():Vector.<ColladaElement>
        {
            if (_children == null)
            {
                _children = new Vector.<ColladaElement>();
                for each (var xml:XML in _xml.elements())
                {
                    _children.push(new ColladaElement(xml));
                }
            }
            return _children;
        }

        /** The elements of a name in it. */
        public function childrenNamed(name:String):Vector.<ColladaElement>
        {
            var found:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            for each (var candidate:ColladaElement in children)
            {
                if (candidate._name == name)
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
            return TextTokens.of(text);
        }

        /** Its own text, which comments and elements may divide. */
        public function get text():String
        {
            var texts:Array = [];
            for each (var part:XML in _xml.text())
            {
                texts.push(part.toString());
            }
            return texts.join(" ");
        }

        /** The elements with ids anywhere in it, in the document's order. */
        public function get identified():Vector.<ColladaElement>
        {
            var found:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            for each (var xml:XML in _xml.descendants())
            {
                if (xml.nodeKind() == "element" && xml.@id.toString() != "")
                {
                    found.push(new ColladaElement(xml));
                }
            }
            return found;
        }

        /** Its path from the root: names, with ids or, among several without, with numbers from 1. */
        public function get path():String
        {
            var places:Array = [];
            var xml:XML = _xml;
            for (var parent:XML = xml.parent(); parent != null; parent = xml.parent())
            {
                places.unshift(placeOf(xml, parent));
                xml = parent;
            }
            return places.length > 0 ? places.join("/") : _name;
        }

        private static function placeOf(xml:XML, parent:XML):String
        {
            var ownName:String = xml.localName();
            var ownId:String = xml.@id.toString();
            if (ownId != "")
            {
                return ownName + "#" + TextTokens.shorten(ownId);
            }
            var count:int = 0;
            var place:int = 0;
            var ownIndex:int = xml.childIndex();
            var index:int = 0;
            for each (var sibling:XML in parent.children())
            {
                if (sibling.localName() == ownName)
                {
                    count++;
                    place = index == ownIndex ? count : place;
                }
                index++;
            }
            return count == 1 ? ownName : ownName + "[" + place + "]";
        }
    }
}
