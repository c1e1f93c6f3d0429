package starlogo.models.collada
{
    import starlogo.models.ModelError;
    import starlogo.models.TextTokens;
    import starlogo.models.polygons.Triangulator;
    import starlogo.models.polygons.WorkLimit;

    /** A COLLADA document: its elements found by id, their numbers read, and their places named in errors. */
    internal final class ColladaDocument
    {
        private static const MAX_POINTS_READ:int = 4000000;

        /** The element COLLADA. */
        public var root:ColladaElement;

        /** How much may be spent on cutting all the document's polygons. */
        public var triangulation:WorkLimit = new WorkLimit(Triangulator.MAX_WORK);

        private var _pointsRead:int = 0;
        private var _name:String;
        private var _elementsById:Object = null;

        /**
         * @param name the model's name
         * @param source the document's text
         * @throws ModelError if it is no COLLADA document
         */
        public function ColladaDocument(name:String, source:String)
        {
            _name = name;
            refuseIf(source == null, null, "there is no text to read");
            root = parse(source);
            refuseIf(root.name != "COLLADA", null, "expected a COLLADA document, but its root element is <" + root.name + ">");
        }

        /** The first element of a name within an element, which has to be there. */
        public function requiredChild(element:ColladaElement, name:String):ColladaElement
        {
            var found:ColladaElement = element.child(name);
            refuseIf(found == null, element, "expected a <" + name + "> in it");
            return found;
        }

        /** The first input of a semantic in an element, or null. */
        public function input(element:ColladaElement, semantic:String):ColladaElement
        {
            for each (var candidate:ColladaElement in element.childrenNamed("input"))
            {
                if (candidate.attribute("semantic") == semantic)
                {
                    return candidate;
                }
            }
            return null;
        }

        /**
         * The element that an attribute of another one refers to.
         *
         * @param element has the attribute
         * @param attribute its name: "url" or "source"
         * @param names the names that the element may have, the wanted one first
         * @param scope where it is looked for first, or null: some exporters use an id again in each mesh
         */
        public function target(element:ColladaElement, attribute:String, names:Array, scope:ColladaElement = null):ColladaElement
        {
            var url:String = element.attribute(attribute);
            if (url.charAt(0) != "#")
            {
                throw error(element, "expected a " + attribute +
                        " like \"#id\", of an element in this file, but found \"" +
                        TextTokens.shorten(url) + "\"");
            }
            var id:String = url.substr(1);
            for each (var name:String in names)
            {
                var found:ColladaElement = (scope == null ? null : childWithId(scope, name, id)) || elementWithId(name, id);
                if (found != null)
                {
                    return found;
                }
            }
            throw error(element, "there is no <" + names[0] + "> with the id \"" + TextTokens.shorten(id) + "\"");
        }

        /**
         * An element's text as finite numbers.
         *
         * @param count how many there must be
         */
        public function numbers(element:ColladaElement, count:int):Vector.<Number>
        {
            var all:Array = element.words;
            var length:int = all.length;
            if (length != count)
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
        public function toNumber(element:ColladaElement, word:String):Number
        {
            var number:Number = TextTokens.toNumber(word);
            if (number - number != 0)
            {
                throw error(element, "expected finite numbers, but found \"" + TextTokens.shorten(word) + "\"");
            }
            return number;
        }

        /**
         * An attribute that is a whole number, not negative.
         *
         * @param missing what it is if it is not there
         */
        public function integer(element:ColladaElement, attribute:String, missing:Number):Number
        {
            var text:String = element.attribute(attribute);
            var number:Number = text == "" ? missing : Number(text);
            refuseIf(!(number >= 0 && number == Math.floor(number) && number < Number.POSITIVE_INFINITY), element, "expected " +
                    attribute + " to be a whole number, not negative, but found \"" + TextTokens.shorten(text) + "\"");
            return number;
        }

        /** Checks an element's attribute <code>count</code>, if there is one, against what was counted. */
        public function checkCount(element:ColladaElement, counted:int, what:String):void
        {
            refuseIf(integer(element, "count", counted) != counted, element, "its count is " +
                    TextTokens.shorten(element.attribute("count")) + ", but it has " + counted + " " + what);
        }

        /**
         * Counts points that are read: each mesh counts the points that it reads, also if several read the same source.
         *
         * @throws ModelError if they are more than a file of any use has
         */
        public function countPoints(element:ColladaElement, count:int):void
        {
            _pointsRead += count;
            refuseIf(_pointsRead > MAX_POINTS_READ, element, "its geometries have more than " + MAX_POINTS_READ +
                    " points, those of a source counted for each");
        }

        /** An error in an element, or null for the document. */
        public function error(element:ColladaElement, problem:String):ModelError
        {
            return new ModelError(_name, element == null ? "" : element.path, problem);
        }

        /** Refuses the document if something is wrong in an element: see starlogo.models.refuseIf. */
        public function refuseIf(isWrong:Boolean, element:ColladaElement, problem:String):void
        {
            if (isWrong)
            {
                throw error(element, problem);
            }
        }

        private function parse(source:String):ColladaElement
        {
            var parsed:ColladaElement = null;
            try
            {
                // a byte-order mark is no XML to every player
                parsed = source.indexOf("<") < 0 ? null : ColladaElement.parse(source.charCodeAt(0) == 0xFEFF ? source.substr(1) : source);
            }
            catch (failure:TypeError)
            {
                throw error(null, "this is not well-formed XML, or cut off: " + failure.message);
            }
            refuseIf(parsed == null, null, "this is not XML: expected a COLLADA document");
            return parsed;
        }

        private static function childWithId(element:ColladaElement, name:String, id:String):ColladaElement
        {
            for each (var candidate:ColladaElement in element.children)
            {
                if (candidate.name == name && candidate.id == id)
                {
                    return candidate;
                }
            }
            return null;
        }

        private function elementWithId(name:String, id:String):ColladaElement
        {
            if (_elementsById == null)
            {
                _elementsById = {};
                for each (var element:ColladaElement in root.identified)
                {
                    var key:String = keyOf(element.name, element.id);
                    _elementsById[key] = _elementsById[key] || element;
                }
            }
            return _elementsById[keyOf(name, id)];
        }

        /** Never the name of a property that each Object has. */
        private static function keyOf(name:String, id:String):String
        {
            return name + "#" + id;
        }
    }
}
