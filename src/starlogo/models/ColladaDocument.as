package starlogo.models
{
    /** A COLLADA document's elements: found by name and id whatever their namespace, read, and named in errors. */
    internal final class ColladaDocument
    {
        private var _name:String;
        private var _root:XML;
        private var _elementsById:Object = null;

        /**
         * @param name the model's name
         * @param source the document's text
         * @throws ModelError if it is no COLLADA document
         */
        public function ColladaDocument(name:String, source:String)
        {
            _name = name;
            if (source == null)
            {
                throw new ModelError(name, "", "there is no text to read");
            }
            _root = parse(source);
            if (_root.localName() != "COLLADA")
            {
                throw new ModelError(name, "", "expected a COLLADA document, but its root element is <" +
                        _root.localName() + ">");
            }
        }

        /** The element COLLADA. */
        public function get root():XML
        {
            return _root;
        }

        /** The elements of a name within an element. */
        public static function children(element:XML, name:String):XMLList
        {
            return element.elements(new QName(null, name));
        }

        /** The first element of a name within an element, or null. */
        public static function child(element:XML, name:String):XML
        {
            var found:XMLList = element.elements(new QName(null, name));
            return found.length() > 0 ? found[0] : null;
        }

        /** The first element of a name within an element, which has to be there. */
        public function requiredChild(element:XML, name:String):XML
        {
            var found:XML = child(element, name);
            if (found == null)
            {
                throw error(element, "expected a <" + name + "> in it");
            }
            return found;
        }

        /**
         * The element that an attribute of another one refers to.
         *
         * @param element has the attribute
         * @param attribute its name: "url" or "source"
         * @param names the names that the element may have, the wanted one first
         * @param scope where it is looked for first, or null: some exporters use an id again in each mesh
         */
        public function target(element:XML, attribute:String, names:Array, scope:XML = null):XML
        {
            var url:String = element.attribute(attribute).toString();
            if (url.charAt(0) != "#")
            {
                throw error(element, "expected a " + attribute +
                        " like \"#id\", of an element in this file, but found \"" +
                        Words.shorten(url) + "\"");
            }
            var id:String = url.substr(1);
            for each (var name:String in names)
            {
                var found:XML = (scope == null ? null : childWithId(scope, name, id)) || elementWithId(name, id);
                if (found != null)
                {
                    return found;
                }
            }
            throw error(element, "there is no <" + names[0] + "> with the id \"" + Words.shorten(id) + "\"");
        }

        /** An element's text: words divided by white space. */
        public static function words(element:XML):Array
        {
            var texts:XMLList = element.text();
            var all:Array = [];
            for each (var text:XML in texts)
            {
                all.push(text.toString()); // comments may divide the text
            }
            return Words.of(all.join(" "));
        }

        /**
         * An element's text as finite numbers.
         *
         * @param count how many there must be; negative if that is open
         */
        public function numbers(element:XML, count:int = -1):Vector.<Number>
        {
            var all:Array = words(element);
            var length:int = all.length;
            if (count >= 0 && length != count)
            {
                throw error(element, "expected " + count + " numbers, but found " + length);
            }
            var result:Vector.<Number> = new Vector.<Number>(length);
            for (var i:int = 0; i < length; i++)
            {
                result[i] = toNumber(element, all[i]);
            }
            return result;
        }

        /** The finite number that a word of an element's text is. */
        public function toNumber(element:XML, word:String):Number
        {
            var number:Number = Words.toNumber(word);
            if (number - number != 0)
            {
                throw error(element, "expected finite numbers, but found \"" + Words.shorten(word) + "\"");
            }
            return number;
        }

        /**
         * An attribute that is a whole number, not negative.
         *
         * @param missing what it is if it is not there
         */
        public function integer(element:XML, attribute:String, missing:Number):Number
        {
            var text:String = element.attribute(attribute).toString();
            var number:Number = text == "" ? missing : Number(text);
            if (!(number >= 0 && number == Math.floor(number) && number < Number.POSITIVE_INFINITY))
            {
                throw error(element, "expected " + attribute + " to be a whole number, not negative, but found \"" +
                        Words.shorten(text) + "\"");
            }
            return number;
        }

        /** Checks an element's attribute <code>count</code>, if there is one, against what was counted. */
        public function checkCount(element:XML, counted:int, what:String):void
        {
            if (integer(element, "count", counted) != counted)
            {
                throw error(element, "its count is " + Words.shorten(element.@count) + ", but it has " + counted +
                        " " + what);
            }
        }

        /** An error in an element. */
        public function error(element:XML, problem:String):ModelError
        {
            return new ModelError(_name, path(element), problem);
        }

        private function parse(source:String):XML
        {
            if (source.indexOf("<") < 0)
            {
                throw new ModelError(_name, "", "this is not XML: expected a COLLADA document");
            }
            try
            {
                // a byte-order mark is no XML to every player
                var xml:XML = new XML(source.charCodeAt(0) == 0xFEFF ? source.substr(1) : source);
            }
            catch (error:TypeError)
            {
                throw new ModelError(_name, "", "this is not well-formed XML, or cut off: " + error.message);
            }
            if (xml.nodeKind() != "element")
            {
                throw new ModelError(_name, "", "this is not XML: expected a COLLADA document");
            }
            return xml;
        }

        private static function childWithId(element:XML, name:String, id:String):XML
        {
            for each (var candidate:XML in children(element, name))
            {
                if (candidate.@id == id)
                {
                    return candidate;
                }
            }
            return null;
        }

        private function elementWithId(name:String, id:String):XML
        {
            if (_elementsById == null)
            {
                _elementsById = new Object();
                for each (var element:XML in _root.descendants())
                {
                    var itsId:String = element.nodeKind() == "element" ? element.@id.toString() : "";
                    if (itsId != "" && _elementsById[element.localName() + "#" + itsId] == null)
                    {
                        _elementsById[element.localName() + "#" + itsId] = element;
                    }
                }
            }
            return _elementsById[name + "#" + id];
        }

        /** The way from the root to an element: names, with ids or, among several without, with numbers from 1. */
        private static function path(element:XML):String
        {
            var steps:Array = [];
            for (var parent:XML = element.parent(); parent != null; parent = element.parent())
            {
                steps.unshift(step(element, parent));
                element = parent;
            }
            return steps.length > 0 ? steps.join("/") : element.localName();
        }

        private static function step(element:XML, parent:XML):String
        {
            var name:String = element.localName();
            var id:String = element.@id.toString();
            if (id != "")
            {
                return name + "#" + Words.shorten(id);
            }
            var siblings:XMLList = children(parent, name);
            if (siblings.length() == 1)
            {
                return name;
            }
            var place:int = 0;
            while (siblings[place].childIndex() != element.childIndex())
            {
                place++;
            }
            return name + "[" + (place + 1) + "]";
        }
    }
}
