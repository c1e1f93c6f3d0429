package starlogo.models
{
    /** Reads Wavefront OBJ text; ObjModel says what of it. */
    internal final class ObjReader implements IModelReader
    {
        private static const LINES_PER_STEP:int = 500;
        private static const POLYGONS_PER_STEP:int = 100;

        // what the text still has to go through, in this order
        private static const LINES:int = 0;
        private static const POLYGONS:int = 1;
        private static const RESULT:int = 2;
        private static const DONE:int = 3;

        private var _name:String;
        private var _upAxis:String;
        private var _lines:Array;
        private var _hasContinuations:Boolean;
        private var _hasComments:Boolean;
        private var _stage:int = LINES;
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
            var text:String = withSimpleSpaces(source);
            _hasContinuations = text.indexOf("\\\n") >= 0;
            _hasComments = text.indexOf(" #") >= 0;
            _lines = text.split("\n");
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
            return _stage == DONE ? 1 : 0.9 * _line / _lines.length;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            switch (_stage)
            {
                case LINES:
                    readLines(_line + LINES_PER_STEP);
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

        /** One space between words, none at either end of a line, one kind of line end: then splitting is cheap. */
        private static function withSimpleSpaces(source:String):String
        {
            var text:String = source.charCodeAt(0) == 0xFEFF ? source.substr(1) : source;
            text = replaceAll(text, "\r\n", "\n");
            text = replaceAll(text, "\r", "\n");
            text = replaceAll(text, "\t", " ");
            while (text.indexOf("  ") >= 0)
            {
                text = replaceAll(text, "  ", " ");
            }
            text = replaceAll(text, " \n", "\n");
            text = replaceAll(text, "\n ", "\n");
            text = text.charCodeAt(0) == 0x20 ? text.substr(1) : text;
            return text.charCodeAt(text.length - 1) == 0x20 ? text.substr(0, text.length - 1) : text;
        }

        private static function replaceAll(text:String, what:String, replacement:String):String
        {
            return text.indexOf(what) < 0 ? text : text.split(what).join(replacement);
        }

        private function readLines(end:int):void
        {
            end = Math.min(end, _lines.length);
            while (_line < end)
            {
                var line:String = _lines[_line];
                switch (line.charCodeAt(0))
                {
                    case 0x76: // v
                        if (line.charCodeAt(1) == 0x20)
                        {
                            readVertex(wordsOf(line));
                        }
                        break;
                    case 0x66: // f
                        if (line.charCodeAt(1) == 0x20)
                        {
                            readFace(wordsOf(line));
                        }
                        break;
                }
                _line++;
            }
            if (_line >= _lines.length)
            {
                checkIndices();
                _stage = POLYGONS;
            }
        }

        /** The words of a statement that begins in a line and may go on in the next ones, a comment after it left out. */
        private function wordsOf(line:String):Array
        {
            if (_hasContinuations)
            {
                while (line.charAt(line.length - 1) == "\\" && _line + 1 < _lines.length)
                {
                    line = withSimpleSpaces(line.substr(0, line.length - 1) + " " + _lines[++_line]);
                }
            }
            if (_hasComments && line.indexOf(" #") >= 0)
            {
                line = line.substr(0, line.indexOf(" #"));
            }
            return line.split(" ");
        }

        private function readVertex(words:Array):void
        {
            var x:Number = Number(words[1]);
            var y:Number = Number(words[2]);
            var z:Number = Number(words[3]);
            if (words.length < 4 || x - x + y - y + z - z != 0)
            {
                throw error("expected a vertex, three finite numbers, but found \"" + shorten(words.join(" ")) + "\"");
            }
            _vertices.push(x, y, z);
            _vertexCount++;
        }

        private function readFace(words:Array):void
        {
            var count:int = words.length - 1;
            if (count == 3)
            {
                _triangles.push(cornerOf(words[1]), cornerOf(words[2]), cornerOf(words[3]));
            }
            else if (count > 3)
            {
                var polygon:Vector.<uint> = new Vector.<uint>(count);
                for (var i:int = 0; i < count; i++)
                {
                    polygon[i] = cornerOf(words[int(i + 1)]);
                }
                _polygons.push(polygon);
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
                        shorten(word) + "\"");
            }
            index = index > 0 ? index - 1 : _vertexCount + index;
            if (index < 0)
            {
                throw error("the corner \"" + shorten(word) + "\" counts back beyond the first vertex: there are " +
                        _vertexCount + " before it");
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
                _line = _highestLine;
                throw error("there is no vertex " + (_highestIndex + 1) + ": the file has " + _vertexCount);
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
            _lines = null;
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
            if (isUsed.indexOf(0) >= 0)
            {
                keepOnly(isUsed);
            }
        }

        private function keepOnly(isUsed:Vector.<uint>):void
        {
            var newIndices:Vector.<uint> = new Vector.<uint>(_vertexCount);
            var count:int = 0;
            for (var i:int = 0; i < _vertexCount; i++)
            {
                if (isUsed[i] == 1)
                {
                    newIndices[i] = count;
                    _vertices[3 * count] = _vertices[3 * i];
                    _vertices[3 * count + 1] = _vertices[3 * i + 1];
                    _vertices[3 * count + 2] = _vertices[3 * i + 2];
                    count++;
                }
            }
            _vertices.length = 3 * count;
            for (i = 0; i < _triangles.length; i++)
            {
                _triangles[i] = newIndices[_triangles[i]];
            }
        }

        private function error(problem:String):ModelError
        {
            return new ModelError(_name, "line " + (_line + 1), problem);
        }

        private static function shorten(text:String):String
        {
            return text.length > 60 ? text.substr(0, 60) + "..." : text;
        }
    }
}
