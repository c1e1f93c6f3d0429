package starlogo.models.gltf
{
    import starlogo.models.ModelError;
    import starlogo.models.files.FileBudget;
    import starlogo.models.text.Decimal;
    import starlogo.steps.Steps;

    /**
     * Reads JSON (RFC 8259), in steps. The player's own parser reads only its strings. It would read a whole file in one step. It is recursive,
     * so deep nesting could overflow the stack. Players differ in long numbers, and their errors name no place.
     */
    internal final class JsonReader implements Steps
    {
        internal static const MAX_DEPTH:int = 100;

        // a value takes a quarter of the memory of an element
        private static const ELEMENTS_PER_VALUE:Number = 0.25;

        private static const CHARACTERS_PER_STEP:int = 2000;
        private static const BACKSLASH:int = 0x5C;

        // Marks. All other characters but white space begin words, which WORD stands for. Then the marks with which a value or a key may begin, and
        // those that may come after a value.
        private static const MARKS:String = "{}[],:\"";
        private static const WORD:String = "w";
        private static const VALUE:String = "{[\"w";
        private static const KEY:String = "\"";
        private static const IN_LIST:String = ",]";
        private static const IN_OBJECT:String = ",}";

        private static const NUMBER:RegExp = /^-?(0|[1-9]\d*)(\.\d+)?([eE][-+]?\d+)?$/;
        private static const WORDS:Object = {"true": true, "false": false, "null": null};

        /** The outermost value, when no step is left. */
        public var root:* = undefined;

        private var _text:String;
        private var _at:int = 0;
        private var _budget:FileBudget;

        // The marks that may come next; none after the outermost value.
        private var _allowed:String = VALUE;

        // The lists and objects that are not closed yet, and the key of the next value in an object.
        private var _open:Array = [];
        private var _key:String;

        /**
         * @param text possible JSON
         * @param budget limits the values
         */
        public function JsonReader(text:String, budget:FileBudget)
        {
            _budget = budget;
            _text = text;
        }

        /**
         * @inheritDoc
         *
         * @throws ModelError if the text is no JSON, or one of the limits is exceeded
         */
        public function step():Boolean
        {
            var end:int = Math.min(_at + CHARACTERS_PER_STEP, _text.length);
            while (_at < end)
            {
                var code:int = _text.charCodeAt(_at++);
                if (code != 0x20 && code != 0x0A && code != 0x0D && code != 0x09)
                {
                    readMark(_text.charAt(_at - 1));
                }
            }
            if (_at == _text.length && _allowed != "")
            {
                throw errorOf("it is cut off");
            }
            return _at < _text.length;
        }

        /** The place of the last character that was read, for errors. */
        public function toString():String
        {
            return "character " + _at;
        }

        // Reads what begins with a character, which is passed already.
        private function readMark(character:String):void
        {
            var mark:String = MARKS.indexOf(character) < 0 ? WORD : character;
            if (_allowed.indexOf(mark) < 0)
            {
                throw errorOf("unexpected " + GltfJson.shown(character));
            }
            switch (mark)
            {
                case "{":
                    open({}, KEY + "}");
                    break;
                case "[":
                    open([], VALUE + "]");
                    break;
                case ",":
                    _allowed = _allowed == IN_LIST ? VALUE : KEY;
                    break;
                case ":":
                    _allowed = VALUE;
                    break;
                case "\"":
                    readString();
                    break;
                case WORD:
                    readWord();
                    break;
                default:
                    _open.pop();
                    endValue();
            }
        }

        private function open(value:Object, allowed:String):void
        {
            put(value);
            _open.push(value);
            _allowed = allowed;
            if (_open.length > MAX_DEPTH)
            {
                throw errorOf("it is nested deeper than " + MAX_DEPTH);
            }
        }

        private function readString():void
        {
            var end:int = endOfString();
            if (end < 0)
            {
                throw errorOf("a string has no end");
            }
            var text:String = decoded(_text.substring(_at - 1, end + 1));
            if (_allowed.indexOf(WORD) >= 0)
            {
                put(text);
            }
            else
            {
                _key = text;
                _allowed = ":";
            }
            _at = end + 1;
        }

        // The string that a text in quotes stands for.
        private function decoded(quoted:String):String
        {
            var text:String = null;
            try
            {
                text = JSON.parse(quoted) as String;
            }
            catch (error:Error)
            {
                // the text stays null
            }
            if (text == null)
            {
                throw errorOf("a string has a wrong character or escape");
            }
            return text;
        }

        // The index of the quote that ends a string; -1 if there is none.
        private function endOfString():int
        {
            var end:int = _at - 1;
            do
            {
                end = _text.indexOf("\"", end + 1);
                var escape:int = end;
                while (escape > _at && _text.charCodeAt(escape - 1) == BACKSLASH)
                {
                    escape--;
                }
            }
            while ((end - escape & 1) == 1);
            return end;
        }

        // Reads a number, true, false or null.
        private function readWord():void
        {
            var end:int = _at;
            while (isInWord(_text.charCodeAt(end)))
            {
                end++;
            }
            var word:String = _text.substring(_at - 1, end);
            // NaN for a word that is too long for the pattern
            var number:Number = Decimal.of(word);
            var isNumber:Boolean = number == number && NUMBER.test(word);
            if (!isNumber && !WORDS.hasOwnProperty(word))
            {
                throw errorOf("a word is no number, true, false or null");
            }
            put(isNumber ? number : WORDS[word]);
            _at = end;
        }

        // Whether a character can be in a word: it is no mark, no white space, and not the end of the text.
        private static function isInWord(code:int):Boolean
        {
            return code > 0x20 && code != 0x22 && code != 0x2C && code != 0x3A && code != 0x5B && code != 0x5D && code != 0x7B && code != 0x7D;
        }

        private function put(value:*):void
        {
            var around:Object = _open.length == 0 ? null : _open[_open.length - 1];
            _budget.spendElements(ELEMENTS_PER_VALUE, this);
            if (around == null)
            {
                root = value;
            }
            else if (around is Array)
            {
                around.push(value);
            }
            else if (_key != "__proto__") // in JavaScript this would change what the object is
            {
                around[_key] = value;
            }
            endValue();
        }

        private function endValue():void
        {
            _allowed = _open.length == 0 ? "" : (_open[_open.length - 1] is Array ? IN_LIST : IN_OBJECT);
        }

        private function errorOf(problem:String):ModelError
        {
            return new ModelError(_budget.modelName, String(this), "its JSON can't be read: " + problem);
        }
    }
}
