package starlogo.models.collada
{
    import standin.Xml;
    import starlogo.models.TextTokens;

    /**
     * An element of a COLLADA document, known by its name in any namespace: stands in for the class that does it with E4X, and does
     * what that does.
     */
    internal final class ColladaElement
    {
        private var _node:Object;
        private var _children:Vector.<ColladaElement> = null;

        /**
         * @param node the element, as the parser gives it
         */
        public function ColladaElement(node:Object)
        {
            _node = node;
        }

        /**
         * The root element of a document; null if there is none.
         *
         * @throws TypeError if it is not well-formed
         */
        internal static function parse(source:String):ColladaElement
        {
            var root:Object = Xml.parse(source);
            return root == null ? null : new ColladaElement(root);
        }

        /** Its name, without that of a namespace. */
        public function get name():String
        {
            return _node.name;
        }

        /** Its id; "" if it has none. */
        public function get id():String
        {
            return attribute("id");
        }

        /** What an attribute is; "" if it is not there. */
        public function attribute(name:String):String
        {
            return attributeOf(_node, name);
        }

        /** The elements in it. */
        public function get children():Vector.<ColladaElement>
        {
            if (_children == null)
            {
                _children = new Vector.<ColladaElement>();
                for each (var node:Object in _node.children)
                {
                    _children.push(new ColladaElement(node));
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

        /** The words of its own text. For one that may be long there is ColladaWords. */
        public function get words():Array
        {
            return TextTokens.of(text);
        }

        /** Its own text, which comments and elements may divide. */
        public function get text():String
        {
            return _node.texts.join(" ");
        }

        /** The elements with ids anywhere in it, in the document's order. */
        public function get identified():Vector.<ColladaElement>
        {
            var found:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            var pending:Array = _node.children.concat().reverse();
            while (pending.length > 0)
            {
                var node:Object = pending.pop();
                if (attributeOf(node, "id") != "")
                {
                    found.push(new ColladaElement(node));
                }
                for (var i:int = node.children.length - 1; i >= 0; i--)
                {
                    pending.push(node.children[i]);
                }
            }
            return found;
        }

        /** The way to it from the root: names, with ids or, among several without, with numbers from 1. */
        public function get path():String
        {
            var places:Array = [];
            for (var node:Object = _node; node.parent != null; node = node.parent)
            {
                places.unshift(placeOf(node));
            }
            return places.length > 0 ? places.join("/") : name;
        }

        private static function attributeOf(node:Object, name:String):String
        {
            return name in node.attributes ? node.attributes[name] : "";
        }

        private static function placeOf(node:Object):String
        {
            var ownId:String = attributeOf(node, "id");
            if (ownId != "")
            {
                return node.name + "#" + TextTokens.shorten(ownId);
            }
            var count:int = 0;
            var place:int = 0;
            for each (var sibling:Object in node.parent.children)
            {
                if (sibling.name == node.name)
                {
                    count++;
                    place = sibling == node ? count : place;
                }
            }
            return count == 1 ? node.name : node.name + "[" + place + "]";
        }
    }
}
