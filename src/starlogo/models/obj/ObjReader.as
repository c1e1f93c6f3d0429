package starlogo.models.obj
{
    import starlogo.models.Decimal;
    import starlogo.models.LineTokens;
    import starlogo.models.ModelError;
    import starlogo.models.ModelLimits;
    import starlogo.models.ModelReader;
    import starlogo.models.TextTokens;
    import starlogo.models.UpAxis;
    import starlogo.models.VertexFilter;
    import starlogo.models.polygons.Triangulator;
    import starlogo.models.refuseIf;
    import starlogo.steps.Steps;

    /**
     * Reads the statements of Wavefront OBJ text; ObjModel says which.
     *
     * @private
     */
    public final class ObjReader extends ModelReader
    {
        private static const WORDS_PER_STEP:int = 1000;
        private static const POLYGONS_PER_STEP:int = 100;
        private static const CORNERS_PER_STEP:int = 1500;

        private var _upAxis:String;
        private var _tokens:LineTokens;
        private var _vertexCount:int = 0;
        private var _isUsed:Vector.<uint> = null;

        // faces with more than three corners wait here until all vertices are known
        private var _polygons:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
        private var _polygonTriangles:int = 0;
        private var _polygon:int = 0;
        private var _triangulator:Triangulator;

        private var _highestIndex:int = -1;
        private var _highestLine:int;
        private var _corners:Vector.<uint> = new Vector.<uint>();

        /**
         * @param name the model's name
         * @param source the text
         * @param upAxis "x", "y" or "z", or a ModelTransform, for which the file is left as it is
         */
        public function ObjReader(name:String, source:String, upAxis:Object)
        {
            super(name);
            _upAxis = UpAxis.of(upAxis, name);
            refuseIf(source == null, name, "there is no text to read");
            refuseIf(source.indexOf("\u0000") >= 0, name, "this is no OBJ text but some binary file");
            _tokens = new LineTokens(source);
            _triangulator = new Triangulator(vertices, triangles);
            repeat(readSome).call(checkIndices).repeat(_triangulator.cuttingBetween(cutPolygons)).begin(droppingUnused).begin(turningUp);
        }

        /** @inheritDoc */
        override public function get progress():Number
        {
            return 0.9 * _tokens.progress;
        }

        /** A step through the words; whether there are more. */
        private function readSome():Boolean
        {
            if (_tokens.isPieceRead)
            {
                if (!_tokens.readPiece())
                {
                    throw errorAt(_tokens.line + 1, "a line, with those that it is continued in, has more than " + LineTokens.MAX_PIECE +
                            " characters");
                }
                return true;
            }
            readWords();
            if (ModelLimits.areExceeded(_vertexCount, triangles.length / 3 + _polygonTriangles))
            {
                throw errorAt(_tokens.line, ModelLimits.PROBLEM);
            }
            return !(_tokens.isPieceRead && _tokens.isLastPiece);
        }

        private function readWords():void
        {
            var tokens:LineTokens = _tokens;
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
                else if (word == LineTokens.END || word == LineTokens.CONTINUED)
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
            var x:Number = Decimal.of(words[at]);
            var y:Number = Decimal.of(words[int(at + 1)]);
            var z:Number = Decimal.of(words[int(at + 2)]);
            if (x - x + y - y + z - z != 0)
            {
                readUnusualVertex();
                return;
            }
            vertices.push(x, y, z);
            _vertexCount++;
            at += 3;
            _tokens.next = at;
            if (words[at] != LineTokens.END)
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
                    throw errorAt(line, "expected a vertex, three finite numbers, but found \"v " +
                            TextTokens.shorten(words.join(" ")) + "\"");
                }
                vertices.push(coordinate);
            }
            _vertexCount++;
        }

        private function readFace():void
        {
            var tokens:LineTokens = _tokens;
            var words:Array = tokens.words;
            var count:int = 0;
            var word:String = words[tokens.next];
            while (word != LineTokens.END)
            {
                var index:int = word == LineTokens.CONTINUED || word.charCodeAt(0) == 0x23 ? -1 : cornerOf(word);
                if (index >= 0)
                {
                    _corners[count++] = index;
                }
                else if (word == LineTokens.CONTINUED)
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
                triangles.push(_corners[0], _corners[1], _corners[2]);
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
                throw errorAt(_tokens.line, "expected a vertex's number in a face's corner (1, 1/2, 1//3 or 1/2/3; not 0), but found \"" +
                        TextTokens.shorten(word) + "\"");
            }
            index = index > 0 ? index - 1 : _vertexCount + index;
            if (index < 0)
            {
                throw errorAt(_tokens.line, "the corner \"" + TextTokens.shorten(word) +
                        "\" counts back beyond the first vertex: there are " + _vertexCount + " before it");
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
            refuseIf(_vertexCount == 0, name, "no vertices: expected lines such as \"v 1 2 3\"");
            if (_highestIndex >= _vertexCount)
            {
                throw errorAt(_highestLine, "there is no vertex " + (_highestIndex + 1) + ": the file has " + _vertexCount);
            }
            _isUsed = new Vector.<uint>(_vertexCount);
        }

        /** Adds the triangles of some polygons; whether there are more. */
        private function cutPolygons():Boolean
        {
            var end:int = Math.min(_polygon + POLYGONS_PER_STEP, _polygons.length);
            var count:int = 0;
            while (_polygon < end && count < CORNERS_PER_STEP && !_triangulator.isCutting)
            {
                var polygon:Vector.<uint> = _polygons[_polygon++];
                _triangulator.addPolygon(polygon);
                for each (var corner:uint in polygon)
                {
                    _isUsed[corner] = 1; // even if it has no triangle
                }
                count += polygon.length;
            }
            return _polygon < _polygons.length;
        }

        /** Where there are faces, only what they use is part of the model's surface. */
        private function droppingUnused():Steps
        {
            return _highestIndex < 0 ? null : new VertexFilter(vertices, triangles, _isUsed);
        }

        private function turningUp():Steps
        {
            return UpAxis.turning(vertices, _upAxis);
        }

        private function errorAt(line:int, problem:String):ModelError
        {
            return new ModelError(name, "line " + line, problem);
        }
    }
}
