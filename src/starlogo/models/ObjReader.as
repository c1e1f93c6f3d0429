package starlogo.models
{
    /** Reads Wavefront OBJ text; ObjModel says what of it. */
    internal final class ObjReader implements ModelReader
    {
        private static const CHARACTERS_PER_PIECE:int = 30000;
        private static const WORDS_PER_STEP:int = 1000;
        private static const POLYGONS_PER_STEP:int = 100;

        // words of the reader's own, of characters that no text uses: a line's end, and one that the next line goes on
        // from
        private static const END:String = "\uE000";
        private static const CONTINUED:String = "\uE001";

        // what the text still has to go through, in this order
        private static const WORDS:int = 0;
        private static const POLYGONS:int = 1;
        private static const RESULT:int = 2;
        private static const DONE:int = 3;

        private var _name:String;
        private var _upAxis:String;
        private var _source:String;
        // the piece of the text from _start up to _end is words now
        private var _start:int = 0;
        private var _end:int = 0;
        private var _words:Array = null;
        private var _word:int;
        private var _stage:int = WORDS;
        private var _line:int = 0;
        private var _polygon:int = 0;

        private var _vertices:Vector.<Number> = new Vector.<Number>();
        private var _vertexCount:int = 0;
        private var _triangles:Vector.<uint> = new Vector.<uint>();
        // faces with more than three corners wait here until all vertices are known
        private var _polygons:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
        private var _triangulator:Triangulator;
        private var _highestIndex:int = -1;
        private var _highestLine:int;
        private var _corners:Vector.<uint> = new Vector.<uint>();

        /**
         * @param name the model's name
         * @param source the text
         * @param upAxis "x", "y" or "z"
         */
        public function ObjReader(name:String, source:String, upAxis:String)
        {
            _name = name;
            _upAxis = upAxis;
            if (!UpAxis.isValid(upAxis))
            {
                throw new ModelError(name, "", "the up axis must be \"x\", \"y\" or \"z\", not \"" + upAxis + "\"");
            }
            if (source == null)
            {
                throw new ModelError(name, "", "there is no text to read");
            }
            if (source.indexOf("\u0000") >= 0)
            {
                throw new ModelError(name, "", "this is no OBJ text but some binary file");
            }
            _source = source.charCodeAt(0) == 0xFEFF ? source.substr(1) : source;
            _triangulator = new Triangulator(_vertices, _triangles);
        }

        /** @inheritDoc */
        public function get vertices():Vector.<Number>
        {
            return _vertices;
        }

        /** @inheritDoc */
        public function get triangles():Vector.<uint>
        {
            return _triangles;
        }

        /** @inheritDoc */
        public function get progress():Number
        {
            if (_words == null)
            {
                return _stage == DONE ? 1 : 0;
            }
            var read:Number = _start + (_end - _start) * _word / _words.length;
            return 0.9 * read / Math.max(1, _source.length);
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            switch (_stage)
            {
                case WORDS:
                    readSome();
                    break;
                case POLYGONS:
                    cutPolygons(_polygon + POLYGONS_PER_STEP);
                    break;
                case RESULT:
                    finish();
                    break;
            }
            return _stage != DONE;
        }

        /** Reads all of it, and is ready with the vertices and triangles. */
        public function readAll():ObjReader
        {
            while (_stage != DONE)
            {
                step();
            }
            return this;
        }

        private function readSome():void
        {
            if (_words == null || _word == _words.length - 1)
            {
                takePiece();
            }
            else
            {
                readWords(_word + WORDS_PER_STEP);
            }
        }

        private function takePiece():void
        {
            _start = _end;
            _end = endOfPiece(_start + CHARACTERS_PER_PIECE);
            // with what makes an end before each line and after it
            _words = wordsOf(_start == 0 ? "\n" : "", _source.substring(_start, _end), _end == _source.length ? "\n" : "");
            _word = 1;
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
            text = Words.replaceAll(text, "\r\n", "\n");
            text = Words.replaceAll(text, "\r", "\n");
            text = Words.replaceAll(text, "\t", " ");
            text = Words.replaceAll(text, "\\\n", " " + CONTINUED + " ");
            text = Words.replaceAll(before + text + after, "\n", " " + END + " ");
            return Words.singleSpaced(" " + text + " ").split(" ");
        }

        private function readWords(end:int):void
        {
            var last:int = _words.length - 1; // nothing
            end = Math.min(end, last);
            while (_word < end)
            {
                var word:String = _words[_word++];
                if (word == "v")
                {
                    readVertex();
                }
                else if (word == "f")
                {
                    readFace();
                }
                else if (word == END || word == CONTINUED)
                {
                    _line++;
                }
                else
                {
                    skipStatement();
                }
            }
            if (_word == last && _end == _source.length)
            {
                checkIndices();
                _stage = POLYGONS;
            }
        }

        // A comment or a path in a material's name may end in a backslash without meaning to be continued. So the next
        // line is looked at anyway; that of a skipped statement's begins with a number and is skipped too.
        private function skipStatement():void
        {
            var word:String = _words[_word];
            while (word != END && word != CONTINUED)
            {
                word = _words[++_word];
            }
        }

        private function readVertex():void
        {
            var x:Number = Number(_words[_word]);
            var y:Number = Number(_words[int(_word + 1)]);
            var z:Number = Number(_words[int(_word + 2)]);
            if (x - x + y - y + z - z != 0)
            {
                readUnusualVertex();
                return;
            }
            _vertices.push(x, y, z);
            _vertexCount++;
            _word += 3;
            if (_words[_word] != END)
            {
                skipStatement();
            }
        }

        private function readUnusualVertex():void
        {
            var line:int = _line;
            var words:Array = restOfStatement();
            for (var i:int = 0; i < 3; i++)
            {
                var coordinate:Number = i < words.length ? Words.toNumber(words[i]) : NaN;
                if (coordinate - coordinate != 0)
                {
                    throw error("expected a vertex, three finite numbers, but found \"v " +
                            Words.shorten(words.join(" ")) + "\"", line);
                }
                _vertices.push(coordinate);
            }
            _vertexCount++;
        }

        /** The words to the end of a statement, over all lines that it is continued in, without a comment. */
        private function restOfStatement():Array
        {
            var words:Array = [];
            for (var word:String = _words[_word]; word != END; word = _words[++_word])
            {
                if (word == CONTINUED)
                {
                    _line++;
                }
                else if (word.charAt(0) == "#")
                {
                    skipStatement();
                    break;
                }
                else
                {
                    words.push(word);
                }
            }
            return words;
        }

        private function readFace():void
        {
            var count:int = 0;
            var word:String = _words[_word];
            while (word != END)
            {
                var index:int = word == CONTINUED || word.charCodeAt(0) == 0x23 ? -1 : cornerOf(word);
                if (index >= 0)
                {
                    _corners[count++] = index;
                }
                else if (word == CONTINUED)
                {
                    _line++;
                }
                else
                {
                    skipStatement();
                    break;
                }
                word = _words[++_word];
            }
            addFace(count);
        }

        private function addFace(count:int):void
        {
            if (count == 3)
            {
                _triangles.push(_corners[0], _corners[1], _corners[2]);
            }
            else if (count > 3)
            {
                _polygons.push(_corners.slice(0, count));
            }
        }

        /** The vertex that a face's corner names: 1, 1/2, 1//3 or 1/2/3. */
        private function cornerOf(word:String):int
        {
            var slash:int = word.indexOf("/");
            var value:Number = Number(slash < 0 ? word : word.substr(0, slash));
            var index:int = int(value);
            if (index != value || index == 0)
            {
                throw error("expected a vertex's number in a face's corner (1, 1/2, 1//3 or 1/2/3; not 0), but found \"" +
                        Words.shorten(word) + "\"", _line);
            }
            index = index > 0 ? index - 1 : _vertexCount + index;
            if (index < 0)
            {
                throw error("the corner \"" + Words.shorten(word) + "\" counts back beyond the first vertex: there are " +
                        _vertexCount + " before it", _line);
            }
            if (index > _highestIndex)
            {
                _highestIndex = index;
                _highestLine = _line;
            }
            return index;
        }

        private function checkIndices():void
        {
            if (_vertexCount == 0)
            {
                throw new ModelError(_name, "", "no vertices: expected lines such as \"v 1 2 3\"");
            }
            if (_highestIndex >= _vertexCount)
            {
                throw error("there is no vertex " + (_highestIndex + 1) + ": the file has " + _vertexCount, _highestLine);
            }
        }

        private function cutPolygons(end:int):void
        {
            end = Math.min(end, _polygons.length);
            while (_polygon < end)
            {
                var polygon:Vector.<uint> = _polygons[_polygon++];
                if (polygon.length == 4)
                {
                    _triangulator.addQuad(polygon[0], polygon[1], polygon[2], polygon[3]);
                }
                else
                {
                    _triangulator.addPolygon(new <Vector.<uint>>[polygon]);
                }
            }
            if (_polygon == _polygons.length)
            {
                _stage = RESULT;
            }
        }

        private function finish():void
        {
            if (_highestIndex >= 0)
            {
                dropUnusedVertices();
            }
            UpAxis.turn(_vertices, _upAxis);
            _words = null;
            _stage = DONE;
        }

        /** Where there are faces, only what they use is part of the model's surface. */
        private function dropUnusedVertices():void
        {
            var isUsed:Vector.<uint> = new Vector.<uint>(_vertexCount);
            for each (var polygon:Vector.<uint> in _polygons)
            {
                for each (var corner:uint in polygon)
                {
                    isUsed[corner] = 1;
                }
            }
            var indexCount:int = _triangles.length;
            for (var i:int = 0; i < indexCount; i++)
            {
                isUsed[_triangles[i]] = 1;
            }
            VertexFilter.keepUsed(_vertices, _triangles, isUsed);
        }

        private function error(problem:String, line:int):ModelError
        {
            return new ModelError(_name, "line " + line, problem);
        }
    }
}
