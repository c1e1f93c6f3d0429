package starlogo.models.text
{
    import starlogo.models.ModelError;
    import starlogo.models.building.ModelReader;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.shortened;
    import starlogo.steps.Steps;

    /**
     * Reads the statements of a text file, such as an OBJ file, one line each, as lists of words without comments. A step reads some, or splits the next
     * chunk of the text into lines, and checks the size of the model so far.
     *
     * @private
     */
    public final class LineReader implements Steps
    {
        // The most characters of a statement: a line with its continuation lines. It is read in one step.
        private static const MAX_STATEMENT:int = 1000000;

        private static const RETURN:int = 0x0D;
        private static const LINE_FEED:int = 0x0A;
        private static const CHARACTERS_PER_CHUNK:int = 30000;
        private static const STATEMENTS_PER_STEP:int = 250;
        private static const COMMENT:RegExp = /(^| )#[^\n]*/;

        /** The number of the line where the present statement begins, from 1. Read only. */
        public var line:int = 1;

        /** What the file may have and cost. Read only. */
        public var budget:FileBudget;

        private var _reader:ModelReader;
        private var _text:String;
        private var _read:Function;

        // The lines of the present chunk that are not read yet, the last one first; and where it ends in the text.
        private var _lines:Array = [];
        private var _end:int = 0;

        private var _lineCount:int = 0; // before the next line

        /**
         * @param reader of the file
         * @param text the text, without a byte-order mark
         * @param read <code>function(words:Array):void</code>; gets the words of a statement, at least one
         */
        public function LineReader(reader:ModelReader, text:String, read:Function)
        {
            _reader = reader;
            _text = text;
            _read = read;
            budget = new FileBudget(reader.data.name, text.length);
        }

        /** The place of a line, for errors. */
        public static function placeOf(line:int):String
        {
            return "line " + line;
        }

        /** The place of the present statement, for errors. */
        public function toString():String
        {
            return placeOf(line);
        }

        /** The error for something that is wrong with the present statement. */
        public function error(problem:String):ModelError
        {
            return new ModelError(_reader.data.name, String(this), problem);
        }

        /** @inheritDoc @throws ModelError if a statement is wrong or too long, or the model has too many vertices or triangles */
        public function step():Boolean
        {
            if (_lines.length == 0)
            {
                readChunk();
            }
            else
            {
                for (var i:int = 0; i < STATEMENTS_PER_STEP && _lines.length > 0; i++)
                {
                    var words:Array = nextStatement();
                    if (words.length > 0)
                    {
                        _read(words);
                    }
                }
            }
            _reader.progress = _end / Math.max(1, _text.length);
            budget.checkMeshSize(_reader.data.vertices.length / 3, _reader.data.triangles.length / 3, this);
            return hasMore;
        }

        private function get hasMore():Boolean
        {
            return _lines.length > 0 || _end < _text.length;
        }

        /**
         * Reads three words of a statement as a vertex.
         *
         * @param words the words
         * @param first the index of the first one
         * @param out receives the three numbers
         * @param at the index of the first in out
         * @throws ModelError if they are not three finite numbers
         */
        public function readPoint(words:Array, first:int, out:Vector.<Number>, at:int):void
        {
            for (var i:int = 0; i < 3; i++)
            {
                var number:Number = Decimal.of(words[int(first + i)]);
                if (!isFinite(number))
                {
                    throw error("expected a vertex, three finite numbers, but found \"" + shortened(words.slice(first - 1).join(" ")) + "\"");
                }
                out[int(at + i)] = number;
            }
        }

        // The words of the next line, and of those that continue it. A comment is not continued.
        private function nextStatement():Array
        {
            var words:Array = [];
            var length:int = -1;
            line = _lineCount + 1;
            do
            {
                if (_lines.length == 0)
                {
                    readChunk();
                }
                var next:String = _lines.pop();
                _lineCount++;
                length += 1 + next.length;
                if (length > MAX_STATEMENT)
                {
                    throw error("a line and its continuation lines have more than " + MAX_STATEMENT + " characters");
                }
                next = TextWords.singleSpaced(next);
                if (next.indexOf("#") >= 0)
                {
                    next = next.replace(COMMENT, "");
                }
                // the last line of the text has no end that could be continued
                var isContinued:Boolean = next.charAt(next.length - 1) == "\\" && hasMore;
                for each (var word:String in (isContinued ? next.substr(0, next.length - 1) : next).split(" "))
                {
                    if (word != "")
                    {
                        words.push(word);
                    }
                }
            }
            while (isContinued);
            return words;
        }

        // Splits the next chunk into lines. It ends where a line ends.
        private function readChunk():void
        {
            var start:int = _end;
            _end = TextWords.indexOfEither(_text, LINE_FEED, RETURN, Math.min(start + CHARACTERS_PER_CHUNK, _text.length), _text.length);
            _end = Math.min(_end + (_text.substr(_end, 2) == "\r\n" ? 2 : 1), _text.length);
            var text:String = _text.substring(start, _end);
            text = TextWords.replaceAll(text, "\r\n", "\n");
            text = TextWords.replaceAll(text, "\r", "\n");
            text = TextWords.replaceAll(text, "\t", " ");
            _lines = text.split("\n");
            if (_end < _text.length)
            {
                // after the last line's end
                _lines.pop();
            }
            _lines.reverse();
        }
    }
}
