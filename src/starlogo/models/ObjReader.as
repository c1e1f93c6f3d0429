package starlogo.models
{
    import starlogo.steps.Slices;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Reads the statements of Wavefront OBJ text; ObjModel says which. */
    internal final class ObjReader implements ModelReader
    {
        private static const WORDS_PER_STEP:int = 1000;
        private static const POLYGONS_PER_STEP:int = 100;
        private static const CORNERS_PER_STEP:int = 1500;
        private static const MARKS_PER_STEP:int = 20000;

        private var _name:String;
        private var _upAxis:String;
        private var _tokens:ObjTokens;
        private var _polygon:int = 0;
        private var _isDone:Boolean = false;
        private var _isUsed:Vector.<uint> = null;
        private var _work:StepSequence = new StepSequence().repeat(readSome).repeat(cutPolygons).begin(markUsed).begin(dropUnused)
            .begin(turnUp).call(conclude);

        private var _vertices:Vector.<Number> = new Vector.<Number>();
        private var _vertexCount:int = 0;
        private var _triangles:Vector.<uint> = new Vector.<uint>();
        // faces with more than three corners wait here until all vertices are known
        private var _polygons:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
        private var _polygonTriangles:int = 0;
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
            _tokens = new ObjTokens(source);
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
            return _isDone ? 1 : 0.9 * _tokens.progress;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            return _work.step();
        }

        /** A step through the words; whether there are more. */
        private function readSome():Boolean
        {
            if (_tokens.isPieceRead)
            {
                if (!_tokens.takePiece())
                {
                    throw error("a line, with those that it is continued in, has more than " + ObjTokens.MAX_PIECE + " characters",
                            _tokens.line + 1);
                }
                return true;
            }
            readWords();
            if (ModelLimits.areExceeded(_vertexCount, _triangles.length / 3 + _polygonTriangles))
            {
                throw error(ModelLimits.PROBLEM, _tokens.line);
            }
            if (_tokens.isPieceRead && _tokens.isLastPiece)
            {
                checkIndices();
                return false;
            }
            return true;
        }

        private function readWords():void
        {
            var tokens:ObjTokens = _tokens;
            var words:Array = tokens.words;
            var end:int = Math.min(tokens.next + WORDS_PER_STEP, words.length - 1);
            while (tokens.next < end)
            {
                var word:String = words[tokens.next++];
                if (word == "v")
                {
                    readVertex();
                }
                else if (word == "f")
                {
                    readFace();
                }
                else if (word == ObjTokens.END || word == ObjTokens.CONTINUED)
                {
                    tokens.line++;
                }
                else
                {
                    tokens.skipStatement();
                }
            }
        }

        private function readVertex():void
        {
            var words:Array = _tokens.words;
            var at:int = _tokens.next;
            var x:Number = Number(words[at]);
            var y:Number = Number(words[int(at + 1)]);
            var z:Number = Number(words[int(at + 2)]);
            if (x - x + y - y + z - z != 0)
            {
                readUnusualVertex();
                return;
            }
            _vertices.push(x, y, z);
            _vertexCount++;
            at += 3;
            _tokens.next = at;
            if (words[at] != ObjTokens.END)
            {
                _tokens.skipStatement();
            }
        }

        private function readUnusualVertex():void
        {
            var line:int = _tokens.line;
            var words:Array = _tokens.restOfStatement();
            for (var i:int = 0; i < 3; i++)
            {
                var coordinate:Number = i < words.length ? TextTokens.toNumber(words[i]) : NaN;
                if (coordinate - coordinate != 0)
                {
                    throw error("expected a vertex, three finite numbers, but found \"v " +
                            TextTokens.shorten(words.join(" ")) + "\"", line);
                }
                _vertices.push(coordinate);
            }
            _vertexCount++;
        }

        private function readFace():void
        {
            var tokens:ObjTokens = _tokens;
            var words:Array = tokens.words;
            var count:int = 0;
            var word:String = words[tokens.next];
            while (word != ObjTokens.END)
            {
                var index:int = word == ObjTokens.CONTINUED || word.charCodeAt(0) == 0x23 ? -1 : cornerOf(word);
                if (index >= 0)
                {
                    _corners[count++] = index;
                }
                else if (word == ObjTokens.CONTINUED)
                {
                    tokens.line++;
                }
                else
                {
                    tokens.skipStatement();
                    break;
                }
                word = words[++tokens.next];
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
                _polygonTriangles += count - 2;
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
                        TextTokens.shorten(word) + "\"", _tokens.line);
            }
            index = index > 0 ? index - 1 : _vertexCount + index;
            if (index < 0)
            {
                throw error("the corner \"" + TextTokens.shorten(word) + "\" counts back beyond the first vertex: there are " +
                        _vertexCount + " before it", _tokens.line);
            }
            if (index > _highestIndex)
            {
                _highestIndex = index;
                _highestLine = _tokens.line;
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

        /** A step through the polygons; whether there are more. */
        private function cutPolygons():Boolean
        {
            if (_triangulator.isCutting)
            {
                _triangulator.cutSome();
                return _triangulator.isCutting || _polygon < _polygons.length;
            }
            var end:int = Math.min(_polygon + POLYGONS_PER_STEP, _polygons.length);
            var corners:int = 0;
            while (_polygon < end && corners < CORNERS_PER_STEP && !_triangulator.isCutting)
            {
                var polygon:Vector.<uint> = _polygons[_polygon++];
                corners += polygon.length;
                if (polygon.length == 4)
                {
                    _triangulator.addQuad(polygon[0], polygon[1], polygon[2], polygon[3]);
                }
                else
                {
                    _triangulator.addPolygon(new <Vector.<uint>>[polygon]);
                }
            }
            return _triangulator.isCutting || _polygon < _polygons.length;
        }

        /** Where there are faces, only what they use is part of the model's surface. */
        private function markUsed():Steps
        {
            if (_highestIndex < 0)
            {
                return null;
            }
            _isUsed = new Vector.<uint>(_vertexCount);
            return new StepSequence().add(new Slices(_polygons.length, POLYGONS_PER_STEP, markPolygons))
                .add(new Slices(_triangles.length, MARKS_PER_STEP, markTriangles));
        }

        private function markPolygons(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                for each (var corner:uint in _polygons[i])
                {
                    _isUsed[corner] = 1;
                }
            }
        }

        private function markTriangles(first:int, end:int):void
        {
            var isUsed:Vector.<uint> = _isUsed;
            for (var i:int = first; i < end; i++)
            {
                isUsed[_triangles[i]] = 1;
            }
        }

        private function dropUnused():Steps
        {
            return _isUsed == null ? null : new VertexFilter(_vertices, _triangles, _isUsed);
        }

        private function turnUp():Steps
        {
            return UpAxis.turning(_vertices, _upAxis);
        }

        private function conclude():void
        {
            _isDone = true;
        }

        private function error(problem:String, line:int):ModelError
        {
            return new ModelError(_name, "line " + line, problem);
        }
    }
}
