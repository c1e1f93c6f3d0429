package starlogo.models.text
{
    import starlogo.models.ModelError;
    import starlogo.models.files.refuseIf;
    import starlogo.models.files.shortened;

    /**
     * Divides text that has one statement per line into words, some lines at a time. A format's reader gets the first word of a
     * statement, and asks for the others. A word that it does not ask for or skip, it gets as if it were a first one.
     *
     * @private
     */
    public final class LineReader
    {
        // Marks of a line's end, and of a line's end after which the next line continues the statement. They are words made of characters that no
        // text uses.
        private static const END:String = "\uE000";
        private static const CONTINUED:String = "\uE001";

        // The most characters of a statement: a line with its continuation lines. It is read in one step.
        private static const MAX_STATEMENT:int = 1000000;

        private static const RETURN:int = 0x0D;
        private static const LINE_FEED:int = 0x0A;
        private static const CHARACTERS_PER_PIECE:int = 30000;
        private static const WORDS_PER_STEP:int = 1000;
        private static const HASH:int = 0x23;

        private var _name:String;
        private var _text:String;

        // The piece that is being read is the text from _start up to _end. Its words, with marks; the first and the last are empty. The index of
        // the next word, and its line, from 1.
        private var _words:Array = [""];
        private var _next:int = 0;
        private var _line:int = 0;
        private var _start:int = 0;
        private var _end:int = 0;

        /**
         * @param name the model's name, for errors
         * @param text the text; a byte-order mark is skipped
         */
        public function LineReader(name:String, text:String)
        {
            _name = name;
            _text = TextWords.withoutByteOrderMark(text);
        }

        /** The place of a line, for errors. */
        public static function placeOf(line:int):String
        {
            return "line " + line;
        }

        /** The number of the next word's line, from 1. */
        public function get line():int
        {
            return _line;
        }

        /** The place of the next word, for errors. */
        public function get place():String
        {
            return placeOf(line);
        }

        /** Whether there is more to read. */
        public function get hasMore():Boolean
        {
            return _next < _words.length - 1 || _end < _text.length;
        }

        /**
         * Does a step: reads some statements, or none if the next piece of the text must be divided first.
         *
         * @param read <code>function(word:String):void</code>; gets a statement's first word, and reads or skips the others
         * @return the share of the text that is read, from 0 to 1
         */
        public function readStatements(read:Function):Number
        {
            var stop:int = 0;
            if (_next == _words.length - 1)
            {
                readPiece();
            }
            else
            {
                stop = Math.min(_next + WORDS_PER_STEP, _words.length - 1);
            }
            while (_next < stop)
            {
                var word:String = _words[_next++];
                if (word == END || word == CONTINUED)
                {
                    _line++;
                }
                else
                {
                    read(word);
                }
            }
            return hasMore ? (_start + (_end - _start) * _next / _words.length) / _text.length : 1;
        }

        /**
         * Reads the next three words of the statement as a vertex, and moves on.
         *
         * @param out receives the three numbers
         * @param at the index of the first in out
         * @throws ModelError if they are not three finite numbers
         */
        public function readPoint(out:Vector.<Number>, at:int):void
        {
            var x:Number = Decimal.of(_words[_next]);
            var y:Number = Decimal.of(_words[int(_next + 1)]);
            var z:Number = Decimal.of(_words[int(_next + 2)]);
            if (x - x + y - y + z - z != 0)
            {
                readUnusualPoint(out, at);
                return;
            }
            out[at] = x;
            out[at + 1] = y;
            out[at + 2] = z;
            _next += 3;
        }

        // Reads a vertex with decimal commas, or over continued lines.
        private function readUnusualPoint(out:Vector.<Number>, at:int):void
        {
            var statement:Array = [_words[int(_next - 1)]];
            var start:String = place;
            for (var i:int = 0; i < 3; i++)
            {
                var word:String = nextWord();
                var number:Number = word == null ? NaN : TextWords.toNumber(word);
                if (number - number != 0)
                {
                    var found:String = statement.concat(word == null ? [] : word, readRest()).join(" ");
                    throw new ModelError(_name, start, "expected a vertex, three finite numbers, but found \"" + shortened(found) + "\"");
                }
                statement.push(word);
                out[at + i] = number;
            }
        }

        /** Moves on to the end of the line. */
        public function skipLine():void
        {
            var word:String = _words[_next];
            while (word != END && word != CONTINUED)
            {
                word = _words[++_next];
            }
        }

        /** Returns the next word of the statement, and moves on. Null if the statement has ended, or a comment begins. */
        public function nextWord():String
        {
            var word:String = _words[_next];
            while (word == CONTINUED)
            {
                _line++;
                word = _words[++_next];
            }
            if (word == END)
            {
                return null;
            }
            if (word.charCodeAt(0) == HASH)
            {
                skipLine();
                return null;
            }
            _next++;
            return word;
        }

        /** Returns the words that are left of the statement, and moves on to its end. */
        public function readRest():Array
        {
            var rest:Array = [];
            for (var word:String = nextWord(); word != null; word = nextWord())
            {
                rest.push(word);
            }
            return rest;
        }

        private function readPiece():void
        {
            _start = _end;
            _end = findEndOfPiece();
            var text:String = (_start == 0 ? "\n" : "") + _text.substring(_start, _end);
            text = TextWords.replaceAll(text, "\r\n", "\n");
            text = TextWords.replaceAll(text, "\r", "\n");
            text = TextWords.replaceAll(text, "\t", " ");
            text = TextWords.replaceAll(text, "\\\n", " " + CONTINUED + " ");
            text = TextWords.replaceAll(text, "\n", " " + END + " ");
            // the text's end ends a line, even after a mark that continues it
            var end:String = _end == _text.length ? " " + END + " " : " ";
            _words = TextWords.singleSpaced(" " + text + end).split(" ");
            _next = 1;
        }

        // The end of the last statement that ends within CHARACTERS_PER_PIECE. If none does, the next statement is a piece of its own.
        private function findEndOfPiece():int
        {
            var end:int = _start + CHARACTERS_PER_PIECE;
            if (end >= _text.length)
            {
                return _text.length;
            }
            for (var before:int = end; before > _start; before--)
            {
                var code:int = _text.charCodeAt(before - 1);
                if ((code == LINE_FEED || code == RETURN && _text.charCodeAt(before) != LINE_FEED) && !isContinued(before))
                {
                    return before;
                }
            }
            do
            {
                end = TextWords.indexOfEither(_text, LINE_FEED, RETURN, end, Math.min(_text.length, _start + MAX_STATEMENT + 1));
                refuseIf(end - _start > MAX_STATEMENT, _name, "a line and its continuation lines have more than " + MAX_STATEMENT + " characters",
                        placeOf(_start == 0 ? 1 : _line));
                end += _text.charCodeAt(end) == RETURN && _text.charCodeAt(end + 1) == LINE_FEED ? 2 : 1;
            }
            while (end < _text.length && isContinued(end));
            return Math.min(end, _text.length);
        }

        // Whether the next line continues the line that ends before an index.
        private function isContinued(end:int):Boolean
        {
            var last:int = end - 2;
            if (_text.charCodeAt(end - 1) == LINE_FEED && _text.charCodeAt(last) == RETURN)
            {
                last--;
            }
            return _text.charAt(last) == "\\";
        }
    }
}
