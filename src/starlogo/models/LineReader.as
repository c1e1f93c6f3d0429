package starlogo.models
{
    /**
     * Reads text that has one statement per line, some lines at a time. A format overrides <code>readStatement()</code>. That method loops
     * over <code>words</code> itself, because this is fast.
     *
     * @private
     */
    public class LineReader extends ModelReader
    {
        // The marks are words made of characters that no text uses.

        /** Marks a line's end.  */
        protected static const END:String = "\uE000";

        /** Marks a line's end after which the next line continues the statement. */
        protected static const CONTINUED:String = "\uE001";

        // A line is read in one step, together with its continuation lines.
        private static const MAX_PIECE:int = 1000000;

        private static const RETURN:int = 0x0D;
        private static const LINE_FEED:int = 0x0A;
        private static const CHARACTERS_PER_PIECE:int = 30000;
        private static const WORDS_PER_STEP:int = 1000;

        /** The words of the piece that is being read. The first and the last are empty. */
        protected var words:Array = [""];

        /** The index of the next word in <code>words</code>. */
        protected var next:int = 0;

        /** The line number of the next word, from 1. The code that passes a mark must increase it. */
        protected var line:int = 0;

        private var _source:String = "";

        // The piece is the text from _start up to _end.
        private var _start:int = 0;
        private var _end:int = 0;
        private var _ends:NextOfTwo;

        /**
         * @param name the model's name
         * @param bytes the bytes or characters that are present
         * @param upAxis "x", "y" or "z", or a ModelTransform
         */
        public function LineReader(name:String, bytes:int, upAxis:Object)
        {
            super(name, new ModelBudget(name, bytes), upAxis);
        }

        /** The place of a line, for errors. */
        protected static function placeOf(line:int):String
        {
            return "line " + line;
        }

        /** Adds the steps that read a text. @param source the text; a byte-order mark is skipped */
        protected final function readLines(source:String):void
        {
            _source = TextTokens.unmarked(source);
            _ends = new NextOfTwo(_source, "\n", "\r");
            repeat(readSome);
        }

        /**
         * Reads a statement, or the part of it that matters. By default every statement is skipped. @param word its first word; the next
         * one is <code>words[next]</code>
         */
        protected function readStatement(word:String):void
        {
            skipStatement();
        }

        /** The number of triangles so far. */
        protected function get triangleCount():int
        {
            return triangles.length / 3;
        }

        /** Throws if there are too many vertices or triangles so far. */
        protected final function checkLimits(place:String):void
        {
            budget.require(ModelBudget.VERTICES, vertices.length / 3, place);
            budget.require(ModelBudget.TRIANGLES, triangleCount, place);
        }

        /** Moves on to the end of the line. */
        protected final function skipStatement():void
        {
            var word:String = words[next];
            while (word != END && word != CONTINUED)
            {
                word = words[++next];
            }
        }

        /** Returns the words up to the end of the statement or to a comment, without marks. Moves on to that end. */
        protected final function restOfStatement():Array
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

        private function readSome():Boolean
        {
            if (next == words.length - 1)
            {
                readPiece();
            }
            else
            {
                readStatements();
            }
            progress = 0.9 * (_start + (_end - _start) * next / words.length) / Math.max(1, _source.length);
            return next < words.length - 1 || _end < _source.length;
        }

        private function readStatements():void
        {
            var end:int = Math.min(next + WORDS_PER_STEP, words.length - 1);
            while (next < end)
            {
                var word:String = words[next++];
                if (word == END || word == CONTINUED)
                {
                    line++;
                }
                else
                {
                    readStatement(word);
                }
            }
            checkLimits(placeOf(line));
        }

        // Continued lines stay in one piece.
        private function readPiece():void
        {
            _start = _end;
            _end += CHARACTERS_PER_PIECE;
            do
            {
                _end = _ends.after(_end);
                // the second of the two characters that end a line may be the first that is found
                var isSecond:Boolean = _source.charCodeAt(_end) == LINE_FEED && _source.charCodeAt(_end - 1) == RETURN;
                var isContinued:Boolean = _source.charAt(_end - (isSecond ? 2 : 1)) == "\\";
                _end += _source.charCodeAt(_end) == RETURN && _source.charCodeAt(_end + 1) == LINE_FEED ? 2 : 1;
            }
            while (isContinued && _end < _source.length);
            _end = Math.min(_end, _source.length);
            refuseIf(_end - _start > MAX_PIECE, name, "a line and its continuation lines have more than " + MAX_PIECE + " characters", placeOf(line + 1));
            var text:String = (_start == 0 ? "\n" : "") + _source.substring(_start, _end) + (_end == _source.length ? "\n" : "");
            text = TextTokens.replaceAll(text, "\r\n", "\n");
            text = TextTokens.replaceAll(text, "\r", "\n");
            text = TextTokens.replaceAll(text, "\t", " ");
            text = TextTokens.replaceAll(text, "\\\n", " " + CONTINUED + " ");
            text = TextTokens.replaceAll(text, "\n", " " + END + " ");
            words = TextTokens.singleSpaced(" " + text + " ").split(" ");
            next = 1;
        }
    }
}
