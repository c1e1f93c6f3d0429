package starlogo.models.stl
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.geometry.vertices.PointTable;
    import starlogo.models.ModelError;
    import starlogo.models.building.ModelReader;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.ModelFile;
    import starlogo.models.files.refuseModelIf;
    import starlogo.models.text.LineReader;

    /**
     * Reads an STL file, binary or text. StlModel says which parts.
     *
     * @private
     */
    public final class StlReader extends ModelReader
    {
        private static const HEADER_LENGTH:int = 84;
        private static const COUNT_AT:int = 80;
        private static const FACET_LENGTH:int = 50;
        private static const NORMAL_LENGTH:int = 12;
        private static const FACETS_PER_STEP:int = 300;

        private var _points:PointTable;

        // of a text file; null for a binary one
        private var _lines:LineReader = null;

        // of a text file: the number of corners of the present facet so far
        private var _corners:int = 0;

        /**
         * The other parameters are those of StlModel.
         *
         * @param file the file; the endianness of its bytes is set
         */
        public function StlReader(file:ModelFile, upAxis:Object, scaling:String)
        {
            super(file.name, upAxis, scaling);
            if (file.bytes != null && isBinary(file.bytes))
            {
                addBinary(file);
            }
            else
            {
                addText(file.requireText("STL file, or one that is cut off"));
            }
            data.vertices = _points.coordinates;
            call(checkEnd);
        }

        private function addText(text:String):void
        {
            _points = new PointTable(Math.min(text.length / 20, FileBudget.MAX_VERTICES));
            _lines = new LineReader(this, text, readStatement);
            add(_lines);
        }

        private function addBinary(file:ModelFile):void
        {
            var bytes:ByteArray = file.bytes;
            file.checkSize();
            var budget:FileBudget = new FileBudget(data.name, bytes.length);
            bytes.endian = Endian.LITTLE_ENDIAN;
            var count:int = countIn(bytes);
            budget.checkMeshSize(0, count);
            _points = new PointTable(Math.min(3 * count, FileBudget.MAX_VERTICES));
            slices(count, FACETS_PER_STEP, function(first:int, end:int):void
                {
                    readFacets(bytes, first, end);
                    budget.checkMeshSize(data.vertices.length / 3, data.triangles.length / 3, "triangle " + end);
                    progress = end / Math.max(1, count);
                });
        }

        /**
         * Whether the bytes are a binary file: at least as long as the facet count requires. In a text file, four characters stand in the
         * count's place, so the count would be too large. Binary files that begin with "solid" are recognised too. A file without facets
         * ends after the count.
         */
        public static function isBinary(bytes:ByteArray):Boolean
        {
            var count:uint = countIn(bytes);
            return count == 0 ? bytes.length == HEADER_LENGTH : HEADER_LENGTH + Number(FACET_LENGTH) * count <= bytes.length;
        }

        /** Whether the text is an STL file's text. */
        public static function isText(text:String):Boolean
        {
            return /^\s*solid\b[^\n\r]*[\n\r]\s*(facet|endsolid)\b/i.test(text.substr(0, ModelFile.HEAD_LENGTH));
        }

        private static function countIn(bytes:ByteArray):uint
        {
            return (bytes[COUNT_AT] | bytes[COUNT_AT + 1] << 8 | bytes[COUNT_AT + 2] << 16 | bytes[COUNT_AT + 3] << 24) >>> 0;
        }

        private function readFacets(bytes:ByteArray, first:int, end:int):void
        {
            var at:int = HEADER_LENGTH + first * FACET_LENGTH + NORMAL_LENGTH;
            for (var i:int = first; i < end; i++)
            {
                bytes.position = at;
                for (var corner:int = 0; corner < 3; corner++)
                {
                    var x:Number = bytes.readFloat();
                    var y:Number = bytes.readFloat();
                    var z:Number = bytes.readFloat();
                    if (!isFinite(x + y + z)) // floats have no sum that is too large
                    {
                        throw new ModelError(data.name, "triangle " + i, "expected three finite numbers for a vertex, but found " + x + ", " + y + ", " + z);
                    }
                    data.triangles.push(_points.add(x, y, z));
                }
                at += FACET_LENGTH;
            }
        }

        // Reads a line, which may have several statements.
        private function readStatement(words:Array):void
        {
            for (var i:int = 0; i < words.length; i++)
            {
                switch (words[i].toLowerCase().replace("endsolid", "solid"))
                {
                    case "solid":
                        // the rest is its name
                        return;
                    case "vertex":
                        readVertex(words, i + 1);
                        i += 3;
                        break;
                    case "endloop":
                        if (_corners != 3)
                        {
                            throw _lines.error("expected a facet of three vertices, but found " + _corners);
                        }
                        _corners = 0;
                        break;
                    case "outer":
                        if (_corners != 0)
                        {
                            throw _lines.error("a loop begins before the last one has ended");
                        }
                }
            }
        }

        private function readVertex(words:Array, first:int):void
        {
            var point:Vector.<Number> = new Vector.<Number>(3, true);
            if (_corners == 3)
            {
                throw _lines.error("a facet has more than three vertices");
            }
            _lines.readPoint(words, first, point, 0);
            data.triangles.push(_points.add(point[0], point[1], point[2]));
            _corners++;
        }

        private function checkEnd():void
        {
            refuseModelIf(_corners != 0, data.name, "the file is cut off: a facet has no end", _lines || "");
            refuseModelIf(data.vertices.length == 0, data.name, "no vertices: expected facets");
        }
    }
}
