package starlogo.models.collada
{
    import starlogo.data.keyOf;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.refuseModelIf;
    import starlogo.models.text.TextWords;
    import starlogo.steps.Steps;

    /**
     * Reads XML, in steps: elements, attributes, texts and CDATA. Comments, processing instructions and declarations are skipped. It
     * expands XML's own entities and numeric character references, and no others. The player's own XML class would parse a whole document in
     * one step, without limits, and the ES module has none.
     */
    internal final class XmlReader implements Steps
    {
        /** The deepest nesting of elements. */
        internal static const MAX_DEPTH:int = 1000;

        /** The most attributes of an element. */
        private static const MAX_ATTRIBUTES:int = 100;

        // The code of the last character of Unicode. An entity with a greater one stays text, as one with an unknown name does.
        private static const LAST_CHARACTER:int = 0x10FFFF;

        private static const MALFORMED:String = "this is not well-formed XML, or cut off";
        private static const TAGS_PER_STEP:int = 100;
        private static const QUOTE:int = 0x22;
        private static const APOSTROPHE:int = 0x27;
        private static const LINE_END:RegExp = /\r\n|\r|\n/;
        private static const NAME_END:RegExp = /[\s\/]/;
        private static const ATTRIBUTE:RegExp = /^\s+([^\s=]+)\s*=\s*$/;
        private static const TAG_END:RegExp = /^\s*\/?$/;
        private static const ENTITY:RegExp = /&(#x[\da-fA-F]+|#\d+|lt|gt|amp|quot|apos);/g;
        private static const ENTITIES:Object = {lt: "<", gt: ">", amp: "&", quot: "\"", apos: "'"};

        /** The root element, when no step is left; null if there is none. */
        public var root:ColladaElement = null;

        private var _budget:FileBudget;
        private var _text:String;
        private var _at:int = 0;
        private var _elementCount:int = 0;

        // the names of the elements that are not closed yet, with their prefixes
        private var _names:Array = [];
        private var _open:ColladaElement = null;

        /**
         * @param text the text
         * @param budget limits the elements
         */
        public function XmlReader(text:String, budget:FileBudget)
        {
            _budget = budget;
            _text = text;
        }

        /**
         * @inheritDoc
         *
         * @throws ModelError if the text is not well-formed, or one of the limits is exceeded
         */
        public function step():Boolean
        {
            for (var i:int = 0; i < TAGS_PER_STEP && _at < _text.length; i++)
            {
                var tag:int = _text.indexOf("<", _at);
                addText(_at, tag < 0 ? _text.length : tag);
                _at = tag < 0 ? _text.length : tag + 1;
                if (tag >= 0)
                {
                    readTag();
                }
            }
            refuseModelIf(_at == _text.length && _open != null, _budget.modelName, MALFORMED, this);
            return _at < _text.length;
        }

        /** The line that is read now, as a place for errors. */
        public function toString():String
        {
            return "line " + _text.substr(0, _at).split(LINE_END).length;
        }

        private function readTag():void
        {
            switch (_text.charAt(_at))
            {
                case "!":
                    readDeclaration();
                    break;
                case "?":
                    _at = endOf("?>");
                    break;
                case "/":
                    closeElement();
                    break;
                default:
                    openElement();
            }
        }

        private function readDeclaration():void
        {
            var isData:Boolean = _text.substr(_at, 8) == "![CDATA[";
            var isComment:Boolean = _text.substr(_at, 3) == "!--";
            var start:int = _at + 8;
            // the dashes at a comment's beginning do not end it
            _at += isComment ? 3 : 0;
            _at = endOf(isData ? "]]>" : (isComment ? "-->" : ">"));
            if (isData && _open != null)
            {
                _open.texts.push(_text.substring(start, _at - 3));
            }
        }

        private function closeElement():void
        {
            var start:int = _at + 1;
            _at = endOf(">");
            refuseModelIf(_open == null || _text.substring(start, _at - 1).split(NAME_END, 1)[0] != _names.pop(), _budget.modelName, MALFORMED, this);
            _open = _open.parent;
        }

        private function openElement():void
        {
            var end:int = endOf(">") - 1;
            var quote:int = TextWords.indexOfEither(_text, QUOTE, APOSTROPHE, _at, end);
            var name:String = _text.substring(_at, quote).split(NAME_END, 1)[0];
            refuseModelIf(name == "" || root != null && _open == null, _budget.modelName, MALFORMED, this);
            _budget.spendElements(1, this);
            var attributes:Object = {};
            _at += name.length;
            for (var count:int = 0; quote < end && count < MAX_ATTRIBUTES; count++)
            {
                var words:Array = ATTRIBUTE.exec(_text.substring(_at, quote));
                var close:int = _text.indexOf(_text.charAt(quote), quote + 1);
                refuseModelIf(words == null || close < 0, _budget.modelName, MALFORMED, this);
                // those with a prefix are of other namespaces: "xml:id", "xmlns:name"
                if (words[1].indexOf(":") < 0)
                {
                    attributes[keyOf(words[1])] = TextWords.trimmed(decoded(_text.substring(quote + 1, close)));
                }
                _at = close + 1;
                end = end < close ? endOf(">") - 1 : end;
                quote = TextWords.indexOfEither(_text, QUOTE, APOSTROPHE, _at, end);
            }
            refuseModelIf(quote < end, _budget.modelName, "an element has more than " + MAX_ATTRIBUTES + " attributes", this);
            refuseModelIf(!TAG_END.test(_text.substring(_at, end)), _budget.modelName, MALFORMED, this);
            var element:ColladaElement = new ColladaElement(_budget, _elementCount++, name.substr(name.indexOf(":") + 1), _open, attributes);
            root ||= element;
            if (_text.charAt(end - 1) != "/")
            {
                _names.push(name);
                _open = element;
            }
            refuseModelIf(_names.length > MAX_DEPTH, _budget.modelName, "elements are nested more than " + MAX_DEPTH + " deep", this);
            _at = end + 1;
        }

        private function addText(start:int, end:int):void
        {
            if (_open != null && start < end)
            {
                _open.texts.push(decoded(_text.substring(start, end)));
            }
        }

        // The index after the next occurrence of a piece. Throws if there is none.
        private function endOf(piece:String):int
        {
            var found:int = _text.indexOf(piece, _at);
            refuseModelIf(found < 0, _budget.modelName, MALFORMED, this);
            return found + piece.length;
        }

        private static function decoded(text:String):String
        {
            return text.indexOf("&") < 0 ? text : text.replace(ENTITY, characterOf);
        }

        private static function characterOf(entity:String, name:String, ...rest):String
        {
            if (name.charAt(0) != "#")
            {
                return ENTITIES[name];
            }
            var code:Number = Number("0" + name.substr(1));
            if (code == 0 || code > LAST_CHARACTER)
            {
                return entity;
            }
            // a string has two units for a character above 0xFFFF
            return code > 0xFFFF ? String.fromCharCode(0xD7C0 + (code >> 10), 0xDC00 | code & 0x3FF) : String.fromCharCode(code);
        }
    }
}
