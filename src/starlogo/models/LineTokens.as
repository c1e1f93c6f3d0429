package starlogo.models
{
    /**
     * The words of text, a piece of some lines at a time, with a mark at each line's end. The reader's own loops go through
     * <code>words</code>, which is what makes it fast.
     *
     * @private
     */
    public final class LineTokens
    {
        // the marks are words of characters that no text uses

        /** Marks a line's end.  */
        public static const END:String = "\uE000";

        /** Marks a line's end after which the next line continues the statement. */
        public static const CONTINUED:String = "\uE001";

        /** How many characters a line may have, and what it is continued in: it is taken in one step. */
        public static const MAX_PIECE:int = 1000000;

        private static const CHARACTERS_PER_PIECE:int = 30000;

        /** The words of the present piece. The first and the last are nothing; there are none before the first piece. */
        public var words:Array = [""];

        /** Where in <code>words</code> the next one is. */
        public var next:int = 0;

        /** The number of the next word's line, from 1; what passes a mark counts it. */
        public var line:int = 0;

        private var _source:String;

        // the piece is the text from _start up to _end
        private var _start:int = 0;
        private var _end:int = 0;

        /**
         * @param source the text; a byte-order mark is left out
         */
        public function LineTokens(source:String)
        {
            _source = source.charCodeAt(0) == 0xFEFF ? source.substr(1) : source;
        }

        /** Whether all words of the present piece are read. */
        public function get isPieceRead():Boolean
        {
            return next == words.length - 1;
        }

        /** Whether there is no piece after the present one. */
        public function get isLastPiece():Boolean
        {
            return _end == _source.length;
        }

        /** How much is read, from 0 to 1. */
        public function get progress():Number
        {
            return (_start + (_end - _start) * next / words.length) / Math.max(1, _source.length);
        }

        /** Goes on to the next piece; false if it is a line that is too long. */
        public function readPiece():Boolean
        {
            _start = _end;
            _end = endOfPiece(_start + CHARACTERS_PER_PIECE);
            if (_end - _start > MAX_PIECE)
            {
                return false;
            }
            // with what makes an end before each line and after it
            words = wordsOf(_start == 0 ? "\n" : "", _source.substring(_start, _end), _end == _source.length ? "\n" : "");
            next = 1;
            return true;
        }

        /**
         * Goes on to the statement's end. A comment or a path in a material's name may end in a backslash without meaning
         * to be continued. So the next line is looked at anyway; that of a skipped statement's begins with a number and
         * is skipped too.
         */
        public function skipStatement():void
        {
            var word:String = words[next];
            while (word != END && word != CONTINUED)
            {
                word = words[++next];
            }
        }

        /** The words to the end of a statement, over all lines that it is continued in, without a comment. */
        public function restOfStatement():Array
        {
            var rest:Array = [];
            for (var word:String = words[next]; word != END; word = words[++next])
            {
                if (word == CONTINUED)
                {
                    line++;
                }
                else if (word.charAt(0) == "#")
                {
                    skipStatement();
                    break;
                }
                else
                {
                    rest.push(word);
                }
            }
            return rest;
        }

        /** Pieces end with a line, and with one that is not continued. */
        private function endOfPiece(from:int):int
        {
            var place:int = _source.indexOf("\n", from);
            while (place >= 0)
            {
                var before:int = _source.charCodeAt(place - 1) == 0x0D ? place - 2 : place - 1;
                if (_source.charAt(before) != "\\")
                {
                    return place + 1;
                }
                place = _source.indexOf("\n", place + 1);
            }
            return _source.length;
        }

        /**
         * Splitting is native and cheap: so the text is made into words that one space divides, END after each line. The
         * first word and the last are nothing.
         */
        private static function wordsOf(before:String, text:String, after:String):Array
        {
            text = TextTokens.replaceAll(text, "\r\n", "\n");
            text = TextTokens.replaceAll(text, "\r", "\n");
            text = TextTokens.replaceAll(text, "\t", " ");
            text = TextTokens.replaceAll(text, "\\\n", " " + CONTINUED + " ");
            text = TextTokens.replaceAll(before + text + after, "\n", " " + END + " ");
            return TextTokens.split(TextTokens.singleSpaced(" " + text + " "));
        }
    }
}
