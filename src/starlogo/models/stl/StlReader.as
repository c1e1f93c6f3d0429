package starlogo.models.stl
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.geometry.PointTable;
    import starlogo.models.Decimal;
    import starlogo.models.LineTokens;
    import starlogo.models.ModelError;
    import starlogo.models.ModelLimits;
    import starlogo.models.ModelReader;
    import starlogo.models.TextTokens;
    import starlogo.models.UpAxis;
    import starlogo.models.refuseIf;
    import starlogo.steps.Steps;

    /**
     * Reads an STL file, binary or text; StlModel says what of it.
     *
     * @private
     */
    public final class StlReader extends ModelReader
    {
        private static const HEADER_LENGTH:int = 84;
        private static const COUNT_PLACE:int = 80;
        private static const FACET_LENGTH:int = 50;
        private static const NORMAL_LENGTH:int = 12;
        private static const FACETS_PER_STEP:int = 300;
        private static const WORDS_PER_STEP:int = 1000;

        private var _upAxis:String;
        private var _points:PointTable;

        // a binary file
        private var _bytes:ByteArray;
        private var _count:int;
        private var _facet:int = 0;

        // text, and how many corners the present facet has so far
        private var _tokens:LineTokens = null;
        private var _corners:int = 0;

        /**
         * @param name the model's name
         * @param bytes a binary file; its endianness is set; null for text
         * @param text the text; null for a binary file
         * @param upAxis "x", "y" or "z", or a ModelTransform, for which the file is left as it is
         */
        public function StlReader(name:String, bytes:ByteArray, text:String, upAxis:Object)
        {
            super(name);
            _upAxis = UpAxis.of(upAxis, name);
            _bytes = bytes;
            if (bytes != null)
            {
                bytes.endian = Endian.LITTLE_ENDIAN;
                _count = countIn(bytes);
                refuseIf(ModelLimits.areExceeded(0, _count), name, ModelLimits.PROBLEM);
                _points = new PointTable(Math.min(3 * _count, ModelLimits.VERTICES));
                slices(_count, FACETS_PER_STEP, readFacets);
            }
            else
            {
                _points = new PointTable(Math.min(text.length / 20, ModelLimits.VERTICES));
                _tokens = new LineTokens(text);
                repeat(readSome).call(checkEnd);
            }
            call(takePoints).begin(turningUp);
        }

        /**
         * Whether bytes are a binary file: as long as its count of facets says, or longer. Text never is, for that count would be of four of its
         * characters, and not even the first of these files that begins with "solid", as text does, is taken for text.
         */
        public static function isBinary(bytes:ByteArray):Boolean
        {
            return bytes.length >= HEADER_LENGTH && HEADER_LENGTH + Number(FACET_LENGTH) * countIn(bytes) <= bytes.length;
        }

        /** Whether text is that of an STL file. */
        public static function isText(text:String):Boolean
        {
            return /^﻿?\s*solid\b[^\n\r]*[\n\r]\s*(facet|endsolid)\b/i.test(text.substr(0, 1000));
        }

        /** @inheritDoc */
        override public function get progress():Number
        {
            return 0.9 * (_tokens == null ? _facet / Math.max(1, _count) : _tokens.progress);
        }

        private static function countIn(bytes:ByteArray):uint
        {
            return (bytes[COUNT_PLACE] | bytes[COUNT_PLACE + 1] << 8 | bytes[COUNT_PLACE + 2] << 16 | bytes[COUNT_PLACE + 3] << 24) >>> 0;
        }

        private function readFacets(first:int, end:int):void
        {
            var bytes:ByteArray = _bytes;
            var place:int = HEADER_LENGTH + first * FACET_LENGTH + NORMAL_LENGTH;
            for (var i:int = first; i < end; i++)
            {
                bytes.position = place;
                for (var corner:int = 0; corner < 3; corner++)
                {
                    var x:Number = bytes.readFloat();
                    var y:Number = bytes.readFloat();
                    var z:Number = bytes.readFloat();
                    if (x - x + y - y + z - z != 0)
                    {
                        throw new ModelError(name, "triangle " + i, "expected three finite numbers for a vertex, but found " + x + ", " + y + ", " + z);
                    }
                    triangles.push(_points.indexOf(x, y, z));
                }
                place += FACET_LENGTH;
            }
            _facet = end;
            checkLimits("triangle " + end);
        }

        /** A step through the words; whether there are more. */
        private function readSome():Boolean
        {
            var tokens:LineTokens = _tokens;
            if (tokens.isPieceRead)
            {
                if (!tokens.readPiece())
                {
                    throw new ModelError(name, "line " + (tokens.line + 1), "the line has more than " + LineTokens.MAX_PIECE + " characters");
                }
                return true;
            }
            var words:Array = tokens.words;
            var end:int = Math.min(tokens.next + WORDS_PER_STEP, words.length - 1);
            while (tokens.next < end)
            {
                readStatement(words[tokens.next++]);
            }
            checkLimits("line " + tokens.line);
            return !(tokens.isPieceRead && tokens.isLastPiece);
        }

        private function readStatement(word:String):void
        {
            var tokens:LineTokens = _tokens;
            if (word == LineTokens.END || word == LineTokens.CONTINUED)
            {
                tokens.line++;
                return;
            }
            switch (word.toLowerCase().replace("endsolid", "solid"))
            {
                case "solid":
                    tokens.skipStatement();
                    break;
                case "vertex":
                    readVertex();
                    break;
                case "endloop":
                    refuseIf(_corners != 3, name, "expected a facet of three vertices, but found " + _corners, "line " + tokens.line);
                    _corners = 0;
                    break;
                case "outer":
                    refuseIf(_corners != 0, name, "a loop begins before the last one has ended", "line " + tokens.line);
            }
        }

        private function readVertex():void
        {
            var words:Array = _tokens.words;
            var at:int = _tokens.next;
            var x:Number = Decimal.of(words[at]);
            var y:Number = Decimal.of(words[int(at + 1)]);
            var z:Number = Decimal.of(words[int(at + 2)]);
            if (x - x + y - y + z - z != 0 || _corners == 3)
            {
                throw new ModelError(name, "line " + _tokens.line, _corners == 3 ? "a facet has more than three vertices"
                        : "expected a vertex, three finite numbers, but found \"" + TextTokens.shorten(_tokens.restOfStatement().join(" ")) + "\"");
            }
            triangles.push(_points.indexOf(x, y, z));
            _tokens.next = at + 3;
            _corners++;
        }

        private function checkEnd():void
        {
            refuseIf(_corners != 0, name, "the file is cut off: a facet has no end", "line " + _tokens.line);
        }

        private function checkLimits(place:String):void
        {
            refuseIf(ModelLimits.areExceeded(_points.coordinates.length / 3, triangles.length / 3), name, ModelLimits.PROBLEM, place);
        }

        private function takePoints():void
        {
            vertices = _points.coordinates;
            refuseIf(vertices.length == 0, name, "no vertices: expected facets");
        }

        private function turningUp():Steps
        {
            return UpAxis.turning(vertices, _upAxis);
        }
    }
}
