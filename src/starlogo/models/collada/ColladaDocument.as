package starlogo.models.collada
{
    import starlogo.models.ModelBudget;
    import starlogo.models.ModelError;
    import starlogo.models.text.Decimal;
    import starlogo.models.text.TextWords;

    /** A COLLADA document. It finds elements by id, reads their numbers, and names their places in errors. */
    internal final class ColladaDocument
    {
        /** The root element, COLLADA. */
        public var root:ColladaElement;

        /** What reading the document may cost. */
        public var budget:ModelBudget;

        private var _elementsById:Object;

        /**
         * @param budget what reading the document may cost
         * @param xml has read the document's text; all its steps must be done
         * @throws ModelError if it is no COLLADA document
         */
        public function ColladaDocument(budget:ModelBudget, xml:XmlReader)
        {
            this.budget = budget;
            root = xml.root;
            refuseIf(root == null, "this is not XML: expected a COLLADA document", "");
            refuseIf(root.name != "COLLADA", "expected a COLLADA document, but its root element is <" + root.name + ">", root);
            _elementsById = xml.elementsById;
        }

        /** Throws a ModelError if something is wrong. @param place the element where it is; "" for no place */
        public function refuseIf(isWrong:Boolean, problem:String, place:Object):void
        {
            if (isWrong)
            {
                throw new ModelError(budget.name, String(place), problem);
            }
        }

        /** The first child element with a name. @throws ModelError if there is none */
        public function requiredChild(element:ColladaElement, name:String):ColladaElement
        {
            var found:ColladaElement = element.child(name);
            refuseIf(found == null, "expected a <" + name + "> in it", element);
            return found;
        }

        /**
         * The element that an attribute refers to.
         *
         * @param element has the attribute
         * @param attribute the attribute's name: "url" or "source"
         * @param names the names that the target may have, the wanted one first
         * @param scope is searched first, because some exporters repeat ids in each mesh; null for no scope
         */
        public function target(element:ColladaElement, attribute:String, names:Array, scope:ColladaElement = null):ColladaElement
        {
            var url:String = element.attribute(attribute);
            refuseIf(url.charAt(0) != "#", "expected a " + attribute + " like \"#id\", of an element in this file, but found \"" +
                    TextWords.shorten(url) + "\"", element);
            var id:String = url.substr(1);
            for each (var name:String in names)
            {
                var found:ColladaElement = (scope == null ? null : scope.childWithId(name, id)) || _elementsById[name + url];
                if (found != null)
                {
                    return found;
                }
            }
            throw new ModelError(budget.name, String(element), "there is no <" + names[0] + "> with the id \"" + TextWords.shorten(id) + "\"");
        }

        /** The material that an instance of a geometry binds to a symbol; null if it binds none, or one that is not in this file. */
        public function materialOf(instance:ColladaElement, symbol:String):ColladaElement
        {
            var binding:ColladaElement = instance.child("bind_material");
            var technique:ColladaElement = binding == null ? null : binding.child("technique_common");
            for each (var bound:ColladaElement in technique == null ? null : technique.childrenNamed("instance_material"))
            {
                if (bound.attribute("symbol") == symbol)
                {
                    return _elementsById["material" + bound.attribute("target")];
                }
            }
            return null;
        }

        /**
         * The numbers in an element's text. @throws ModelError if one is not finite
         *
         * @param count the number of numbers that there must be
         */
        public function numbers(element:ColladaElement, count:int):Vector.<Number>
        {
            var all:Array = element.splitText();
            var length:int = all.length;
            refuseIf(length != count, "expected " + count + " numbers, but found " + length, element);
            var result:Vector.<Number> = new Vector.<Number>(length);
            for (var i:int = 0; i < length; i++)
            {
                result[i] = toNumber(element, all[i]);
            }
            return result;
        }

        /** The number that a word of an element's text stands for. @throws ModelError if it is not finite */
        public function toNumber(element:ColladaElement, word:String):Number
        {
            var number:Number = TextWords.toNumber(word);
            if (number - number != 0)
            {
                throw new ModelError(budget.name, String(element), "expected finite numbers, but found \"" + TextWords.shorten(word) + "\"");
            }
            return number;
        }

        /**
         * The value of an attribute that must be a whole number, 0 or more.
         *
         * @param missing the result if there is no such attribute
         */
        public function integer(element:ColladaElement, attribute:String, missing:Number):Number
        {
            var text:String = element.attribute(attribute);
            var number:Number = text == "" ? missing : Decimal.of(TextWords.of(text).join(" "));
            refuseIf(!(number >= 0 && number == Math.floor(number) && number < Infinity), "expected " +
                    attribute + " to be a whole number, not negative, but found \"" + TextWords.shorten(text) + "\"", element);
            return number;
        }

        /** Checks an element's attribute <code>count</code>, if there is one. @param counted the value that it must have */
        public function checkCount(element:ColladaElement, counted:int, what:String):void
        {
            refuseIf(integer(element, "count", counted) != counted, "its count is " +
                    TextWords.shorten(element.attribute("count")) + ", but it has " + counted + " " + what, element);
        }
    }
}
