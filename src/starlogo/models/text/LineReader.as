package starlogo.models.text
{
    import starlogo.models.refuseIf;

    /**
     * Divides text that has one statement per line into words, some lines at a time. A format's reader gets the first word of each
     * statement, and loops over the other <code>words</code> itself, because this is fast.
     *
     * @private
     */
    public final class LineReader
    {
        // The marks are words made of characters that no text uses.

        /** Marks a line's end.  */
        public static const END:String = "\uE000";

        /** Marks a line's end after which the next line continues the statement. */
        public static const CONTINUED:String = "\uE001";

        // A line is read in one step, together with its continuation lines.
        private static const MAX_PIECE:int = 1000000;

        private static const RETURN:int = 0x0D;
        private static const LINE_FEED:int = 0x0A;
        private static const CHARACTERS_PER_PIECE:int = 30000;
        private static const WORDS_PER_STEP:int = 1000;

        /** The words of the piece that is being read. The first and the last are empty. */
        public var words:Array = [""];

        /** The index of the next word in <code>words</code>. */
        public var next:int = 0;

        /** The line number of the next word, from 1. The code that passes a mark must increase it. */
        public var line:int = 0;

        private var _name:String;
        private var _text:String;

        // The piece is the text from _start up to _end.
        private var _start:int = 0;
        private var _end:int = 0;
        private var _ends:NextOfTwo;

        /**
         * @param name the model's name, for errors
         * @param text the text; a byte-order mark is skipped
         */
        public function LineReader(name:String, text:String)
        {
            _name = name;
            _text = TextWords.withoutByteOrderMark(text);
            _ends = new NextOfTwo(_text, "\n", "\r");
        }

        /** The place of a line, for errors. */
        public static function placeOf(line:int):String
        {
            return "line " + line;
        }

        /** What is wrong with words that should be a vertex. */
        public static function vertexProblem(found:String):String
        {
            return "expected a vertex, three finite numbers, but found \"" + TextWords.shorten(found) + "\"";
        }

        /** The place of the next word, for errors. */
        public function get place():String
        {
            return placeOf(line);
        }

        /** Whether there is more to read. */
        public function get hasMore():Boolean
        {
            return next < words.length - 1 || _end < _text.length;
        }

        /**
         * Does a step: reads some statements, or none if the next piece of the text must be divided first.
         *
         * @param read reads a statement, whose first word it gets: <code>function(word:String):void</code>. The second word is
         * <code>words[next]</code>
         * @return the share of the text that is read, from 0 to 1
         */
        public function readStatements(read:Function):Number
        {
            var stop:int = 0;
            if (next == words.length - 1)
            {
                readPiece();
            }
            else
            {
                stop = Math.min(next + WORDS_PER_STEP, words.length - 1);
            }
            while (next < stop)
            {
                var word:String = words[next++];
                if (word == END || word == CONTINUED)
                {
                    line++;
                }
                else
                {
                    read(word);
                }
            }
            return (_start + (_end - _start) * next / words.length) / Math.max(1, _text.length);
        }

        /**
         * Reads the next three words as decimals, and moves on. If one is not a finite number, it stays where it is.
         *
         * @param out receives the three numbers
         * @param at the index of the first in out
         * @return whether they are finite
         */
        public function readPoint(out:Vector.<Number>, at:int):Boolean
        {
            var x:Number = Decimal.of(words[next]);
            var y:Number = Decimal.of(words[int(next + 1)]);
            var z:Number = Decimal.of(words[int(next + 2)]);
            if (x - x + y - y + z - z != 0)
            {
                return false;
            }
            out[at] = x;
            out[at + 1] = y;
            out[at + 2] = z;
            next += 3;
            return true;
        }

        /** Moves on to the end of the line. */
        public function skipLine():void
        {
            var word:String = words[next];
            while (word != END && word != CONTINUED)
            {
                word = words[++next];
            }
        }

        /** Returns the words up to the end of the statement or to a comment, without marks. Moves on to that end. */
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
                    skipLine();
                    break;
                }
                else
                {
                    rest.push(word);
                }
            }
            return rest;
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
                var isSecond:Boolean = _text.charCodeAt(_end) == LINE_FEED && _text.charCodeAt(_end - 1) == RETURN;
                var isContinued:Boolean = _text.charAt(_end - (isSecond ? 2 : 1)) == "\\";
                _end += _text.charCodeAt(_end) == RETURN && _text.charCodeAt(_end + 1) == LINE_FEED ? 2 : 1;
            }
            while (isContinued && _end < _text.length);
            _end = Math.min(_end, _text.length);
            refuseIf(_end - _start > MAX_PIECE, _name, "a line and its continuation lines have more than " + MAX_PIECE + " characters", placeOf(line + 1));
            var text:String = (_start == 0 ? "\n" : "") + _text.substring(_start, _end) + (_end == _text.length ? "\n" : "");
            text = TextWords.replaceAll(text, "\r\n", "\n");
            text = TextWords.replaceAll(text, "\r", "\n");
            text = TextWords.replaceAll(text, "\t", " ");
            text = TextWords.replaceAll(text, "\\\n", " " + CONTINUED + " ");
            text = TextWords.replaceAll(text, "\n", " " + END + " ");
            words = TextWords.singleSpaced(" " + text + " ").split(" ");
            next = 1;
        }
    }
}
