package starlogo.models.collada
{
    import starlogo.data.keyOf;
    import starlogo.geometry.AffineTransform;
    import starlogo.models.ModelError;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.shortened;
    import starlogo.models.text.Decimal;
    import starlogo.models.text.TextWords;

    /**
     * An element of a COLLADA document. It finds other elements, reads its own numbers, and names its place in errors. Its name has no
     * namespace prefix, and attributes with a prefix are left out.
     */
    internal final class ColladaElement
    {
        /** The element's name. */
        public var name:String;

        /** Its number in the document, from 0. It is the target of animations that move its numbers. */
        public var index:int;

        /** What the document may have and cost. */
        public var budget:FileBudget;

        /** The element around this one; null for the root. */
        public var parent:ColladaElement;

        /** The elements directly inside. */
        public var children:Vector.<ColladaElement> = new Vector.<ColladaElement>();

        /** The pieces of the element's own text. Comments and elements may divide it. */
        public var texts:Array = [];

        // the values of the attributes, by keyOf() their names
        private var _attributes:Object;

        // The first element of the document with each name and id, and with each sid. All elements share it.
        private var _elements:Object;

        // the first child with each name, and with each name and key of child(); null before a child was asked for
        private var _children:Object = null;

        // for an element that is a transform: the transform, after it was first needed
        private var _transform:AffineTransform = null;

        /**
         * @param budget what the document may have and cost
         * @param index its number in the document, from 0
         * @param name the element's name
         * @param parent the element around it, which takes it as a child; null for the root
         * @param attributes the values of its attributes, by keyOf() their names; is kept
         */
        public function ColladaElement(budget:FileBudget, index:int, name:String, parent:ColladaElement, attributes:Object)
        {
            this.budget = budget;
            this.index = index;
            this.name = name;
            this.parent = parent;
            _attributes = attributes;
            _elements = parent == null ? {} : parent._elements;
            if (parent != null)
            {
                parent.children.push(this);
            }
            if (id != "")
            {
                _elements[keyOf(name + "#" + id)] ||= this;
            }
            _elements[keyOf("#" + attribute("sid"))] ||= this;
        }

        /** The element's id; "" if it has none. */
        public function get id():String
        {
            return attribute("id");
        }

        /** Its attribute "name", or its id if it has none; null without both. */
        public function get nameOrId():String
        {
            return attribute("name") || id || null;
        }

        /** Whether an element of the document has a sid. */
        public function hasSid(sid:String):Boolean
        {
            return keyOf("#" + sid) in _elements;
        }

        /** The element of the document with a name, at a URL like "#id"; null if there is none. */
        public function elementAt(name:String, url:String):ColladaElement
        {
            return _elements[keyOf(name + url)];
        }

        /** The transform that this element is; null if it is none. Many nodes may have it, and its text may be long, so it is read once. */
        public function toTransform():AffineTransform
        {
            return _transform ||= ColladaTransform.of(this, null);
        }

        /** The value of an attribute; "" if there is none. */
        public function attribute(name:String):String
        {
            return _attributes[keyOf(name)] || "";
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

        /**
         * The first child element with a name, or null.
         *
         * @param key its id; of an input its semantic, and of an instance_material its symbol. Null for any
         */
        public function child(name:String, key:String = null):ColladaElement
        {
            if (_children == null)
            {
                _children = {};
                for each (var element:ColladaElement in children)
                {
                    var keyName:String = element.name == "input" ? "semantic" : (element.name == "instance_material" ? "symbol" : "id");
                    _children[keyOf(element.name)] ||= element;
                    _children[keyOf(element.name + "#" + element.attribute(keyName))] ||= element;
                }
            }
            return _children[keyOf(key == null ? name : name + "#" + key)];
        }

        /** The first child element with a name. @throws ModelError if there is none */
        public function requiredChild(name:String):ColladaElement
        {
            var found:ColladaElement = child(name);
            refuseIf(found == null, "expected a <" + name + "> in it");
            return found;
        }

        /** The first input with a semantic. @throws ModelError if there is none */
        public function requiredInput(semantic:String):ColladaElement
        {
            var input:ColladaElement = child("input", semantic);
            refuseIf(input == null, "expected an <input> with the semantic " + semantic);
            return input;
        }

        /** How many indices its inputs take together, as their offsets say. @throws ModelError if an offset is wrong */
        public function inputStride():int
        {
            const MAX_OFFSET:int = 255;
            var stride:int = 1;
            for each (var input:ColladaElement in childrenNamed("input"))
            {
                var offset:Number = input.integer("offset", 0);
                input.refuseIf(offset > MAX_OFFSET, "expected an offset of at most " + MAX_OFFSET + ", but found " + offset);
                stride = Math.max(stride, offset + 1);
            }
            return stride;
        }

        /**
         * The element that an attribute refers to.
         *
         * @param attributeName "url" or "source"
         * @param names the names that the target may have, the wanted one first
         * @param scope is searched first, because some exporters repeat ids in each mesh; null for no scope
         * @throws ModelError if there is none
         */
        public function target(attributeName:String, names:Array, scope:ColladaElement = null):ColladaElement
        {
            var url:String = attribute(attributeName);
            refuseIf(url.charAt(0) != "#", "expected a " + attributeName + " like \"#id\", of an element in this file, but found \"" +
                    shortened(url) + "\"");
            for each (var targetName:String in names)
            {
                var found:ColladaElement = (scope == null ? null : scope.child(targetName, url.substr(1))) || elementAt(targetName, url);
                if (found != null)
                {
                    return found;
                }
            }
            throw error("there is no <" + names[0] + "> with the id \"" + shortened(url.substr(1)) + "\"");
        }

        /** The element's own text. Long texts are split into words in steps: see TextWords.splitting(). */
        public function get text():String
        {
            return texts.join(" ");
        }

        /** The element's own text, whose words count as numbers of the document. @throws ModelError if there are too many */
        public function countedText():String
        {
            var all:String = text;
            // each word takes two characters or more: its own, and a space
            budget.spendNumbers(all.length / 2, this);
            return all;
        }

        /**
         * The numbers in the element's text. @throws ModelError if one is not finite
         *
         * @param count the number of numbers that there must be
         */
        public function numbers(count:int):Vector.<Number>
        {
            var all:Array = TextWords.of(text);
            refuseIf(all.length != count, "expected " + count + " numbers, but found " + all.length);
            var result:Vector.<Number> = new Vector.<Number>(count);
            for (var i:int = 0; i < count; i++)
            {
                result[i] = toNumber(all[i]);
            }
            return result;
        }

        /** The number that a word of the element's text stands for. @throws ModelError if it is not finite */
        public function toNumber(word:String):Number
        {
            var number:Number = Decimal.of(word);
            if (!isFinite(number))
            {
                throw error("expected finite numbers, but found \"" + shortened(word) + "\"");
            }
            return number;
        }

        /**
         * The whole number that a word of the element's text stands for. @throws ModelError if it is none, or not in the range
         *
         * @param what what it must be, for the error
         */
        public function toInteger(word:String, least:int, most:int, what:String):int
        {
            var value:Number = Decimal.of(word);
            var whole:int = int(value);
            if (whole != value || whole < least || whole > most)
            {
                throw error("expected " + what + ", " + least + " to " + most + ", but found \"" + shortened(word) + "\"");
            }
            return whole;
        }

        /**
         * The value of an attribute that must be a whole number, 0 or more.
         *
         * @param missing the result if there is no such attribute
         */
        public function integer(attributeName:String, missing:Number):Number
        {
            var value:String = attribute(attributeName);
            var number:Number = value == "" ? missing : Decimal.of(value);
            refuseIf(!(number >= 0 && number == Math.floor(number) && number < Infinity), "expected " +
                    attributeName + " to be a whole number, not negative, but found \"" + shortened(value) + "\"");
            return number;
        }

        /** Checks the attribute <code>count</code>, if there is one. @param counted the value that it must have */
        public function checkCount(counted:int, what:String):void
        {
            refuseIf(integer("count", counted) != counted, "its count is " + shortened(attribute("count")) + ", but it has " + counted + " " + what);
        }

        /** Throws a ModelError if something is wrong with the element. The message is built in any case, so long loops throw an error(). */
        public function refuseIf(isWrong:Boolean, problem:String):void
        {
            if (isWrong)
            {
                throw error(problem);
            }
        }

        /** The error for something that is wrong with the element. */
        public function error(problem:String):ModelError
        {
            return new ModelError(budget.modelName, String(this), problem);
        }

        /** The path from the root: names, with ids. Elements without an id that have siblings of the same name get numbers from 1. */
        public function toString():String
        {
            var path:Array = [];
            for (var element:ColladaElement = this; element.parent != null; element = element.parent)
            {
                path.unshift(element.pathSegment);
            }
            return path.length > 0 ? path.join("/") : name;
        }

        private function get pathSegment():String
        {
            var alike:Vector.<ColladaElement> = parent.childrenNamed(name);
            return name + (id != "" ? "#" + shortened(id) : (alike.length == 1 ? "" : "[" + (alike.indexOf(this) + 1) + "]"));
        }
    }
}
