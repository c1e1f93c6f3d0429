package starlogo.models.collada
{
    import starlogo.models.Decimal;
    import starlogo.models.ModelError;
    import starlogo.models.TextTokens;
    import starlogo.models.polygons.Triangulator;
    import starlogo.models.refuseIf;
    import starlogo.steps.Slices;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Reads one COLLADA primitive that has a surface: triangles, polylist, polygons, tristrips or trifans. */
    internal final class ColladaPrimitive extends StepSequence
    {
        private static const CORNERS_PER_STEP:int = 1500;
        private static const SIZES_PER_STEP:int = 5000;
        private static const MAX_OFFSET:int = 255;
        private static const NAMES:Array = ["triangles", "polylist", "polygons", "tristrips", "trifans"];

        private var _document:ColladaDocument;
        private var _element:ColladaElement;
        private var _positions:ColladaSource;
        private var _isUsed:Vector.<uint>;
        private var _triangles:Vector.<uint>;
        private var _triangulator:Triangulator;

        // A corner takes _stride indices. That of its position is the one at _offset.
        private var _stride:int = 1;
        private var _offset:int;

        // the lists of corners (p or ph), the number of the next one, the words of all, the indices of the present list as texts, and the next
        // of these
        private var _lists:Vector.<ColladaElement>;
        private var _list:int = 0;
        private var _indexWords:ColladaWords;
        private var _indices:Array = [];
        private var _next:int = 0;

        // for a polylist: the number of corners of each polygon, as words and as texts; the next polygon; and the sum of the numbers
        private var _sizeWords:ColladaWords;
        private var _sizes:Array;
        private var _size:int = 0;
        private var _sum:Number = 0;

        /**
         * @param document the document
         * @param element the primitive's element
         * @param positions its points; their steps come before this one's
         * @param isUsed a number for each point of the mesh; set to 1 for points that have a corner
         * @param triangles takes the triangles
         * @param triangulator cuts polygons, and adds their triangles
         */
        public function ColladaPrimitive(document:ColladaDocument, element:ColladaElement, positions:ColladaSource,
                isUsed:Vector.<uint>, triangles:Vector.<uint>, triangulator:Triangulator)
        {
            _document = document;
            _element = element;
            _positions = positions;
            _isUsed = isUsed;
            _triangles = triangles;
            _triangulator = triangulator;
            _lists = element.childrenNamed("p");
            readInputs();
            addParts();
        }

        /** Whether an element is a primitive with a surface. Some programs write empty primitives without inputs. These do not count. */
        internal static function isSurface(element:ColladaElement):Boolean
        {
            return NAMES.indexOf(element.name) >= 0 && element.attribute("count") != "0";
        }

        /**
         * The input with the positions of a primitive's corners.
         *
         * @throws ModelError if there is none
         */
        internal static function positionInput(document:ColladaDocument, element:ColladaElement):ColladaElement
        {
            var input:ColladaElement = element.input("VERTEX") || element.input("POSITION");
            refuseIf(input == null, document.budget.name, "expected an <input> with the semantic VERTEX", element);
            return input;
        }

        private function readInputs():void
        {
            for each (var input:ColladaElement in _element.childrenNamed("input"))
            {
                var offset:Number = _document.integer(input, "offset", 0);
                refuseIf(offset > MAX_OFFSET, _document.budget.name, "expected an offset of at most " + MAX_OFFSET + ", but found " + offset, input);
                _stride = Math.max(_stride, offset + 1);
            }
            _offset = _document.integer(positionInput(_document, _element), "offset", 0);
        }

        private function addParts():void
        {
            switch (_element.name)
            {
                case "triangles":
                    _indexWords = new ColladaWords(_lists);
                    add(_indexWords).begin(readingTriangles);
                    break;
                case "polylist":
                    _indexWords = new ColladaWords(_lists);
                    _sizeWords = new ColladaWords(_element.childrenNamed("vcount").slice(0, 1));
                    add(_indexWords).add(_sizeWords).begin(checkingSizes).repeat(_triangulator.cuttingBetween(readPolylist));
                    break;
                default:
                    var arePolygons:Boolean = _element.name == "polygons";
                    _lists = arePolygons ? _lists.concat(_element.childrenNamed("ph")) : _lists;
                    _document.checkCount(_element, _lists.length, arePolygons ? "polygons" : "lists of corners <p>");
                    repeat(_triangulator.cuttingBetween(readLists));
                    break;
            }
        }

        private function readingTriangles():Steps
        {
            _indices = _indexWords.words;
            refuseIf(cornerCount % 3 != 0, _document.budget.name, "expected three corners for each triangle, but found " + cornerCount, _element);
            _document.checkCount(_element, cornerCount / 3, "triangles");
            return new Slices(cornerCount, CORNERS_PER_STEP, readTriangles);
        }

        private function readTriangles(first:int, end:int):void
        {
            var at:int = _triangles.length;
            for (var i:int = first; i < end; i++)
            {
                _triangles[at++] = cornerAt(i * _stride);
            }
        }

        private function checkingSizes():Steps
        {
            _indices = _indexWords.words;
            _sizes = _sizeWords.words;
            _document.checkCount(_element, _sizes.length, "numbers in <vcount>");
            return new Slices(_sizes.length, SIZES_PER_STEP, addSizes);
        }

        private function addSizes(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var size:Number = Decimal.ofIndex(_sizes[i]);
                if (!(size >= 0 && size <= _indices.length && size == int(size)))
                {
                    throw new ModelError(_document.budget.name, String(_element.child("vcount")), "expected the number of a polygon's corners, but found \"" +
                            TextTokens.shorten(_sizes[i]) + "\"");
                }
                _sum += size;
            }
            refuseIf(end == _sizes.length && _sum != cornerCount, _document.budget.name, "its <vcount> adds up to " + _sum + " corners, but <p> has " +
                    cornerCount, _element);
        }

        private function readPolylist():Boolean
        {
            var end:int = _next + CORNERS_PER_STEP * _stride;
            while (_size < _sizes.length && _next <= end && !_triangulator.isCutting)
            {
                var count:int = Number(_sizes[_size++]);
                if (count > 2)
                {
                    _triangulator.addPolygon(cornersAt(_next, count));
                }
                _next += count * _stride;
            }
            return _size < _sizes.length;
        }

        private function readLists():Boolean
        {
            var read:int = 0;
            while (read < CORNERS_PER_STEP && _list < _lists.length && !_triangulator.isCutting)
            {
                var element:ColladaElement = _lists[_list++];
                var loop:Vector.<uint> = loopOf(element.name == "ph" ? _document.requiredChild(element, "p") : element);
                if (_element.name == "polygons")
                {
                    _triangulator.addPolygon(loop, holesOf(element));
                }
                else
                {
                    addStrip(loop);
                }
                read += 10 + loop.length;
            }
            return _list < _lists.length;
        }

        // The holes of a polygon with holes (ph).
        private function holesOf(element:ColladaElement):Vector.<Vector.<uint>>
        {
            var holes:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
            for each (var hole:ColladaElement in element.name == "ph" ? element.childrenNamed("h") : null)
            {
                holes.push(loopOf(hole));
            }
            return holes;
        }

        private function addStrip(strip:Vector.<uint>):void
        {
            var isFan:Boolean = _element.name == "trifans";
            for (var i:int = 2; i < strip.length; i++)
            {
                var first:int = isFan ? 0 : i - 2 + (i & 1);
                var second:int = isFan ? i - 1 : i - 1 - (i & 1);
                _triangulator.addTriangle(strip[first], strip[second], strip[i]);
            }
        }

        private function loopOf(element:ColladaElement):Vector.<uint>
        {
            _indices = element.words;
            return cornersAt(0, cornerCount);
        }

        // Some corners. The indices of the first one begin at the given place.
        private function cornersAt(place:int, count:int):Vector.<uint>
        {
            var corners:Vector.<uint> = new Vector.<uint>(count);
            for (var i:int = 0; i < count; i++)
            {
                corners[i] = cornerAt(place + i * _stride);
            }
            return corners;
        }

        // The number of corners in the present list.
        private function get cornerCount():int
        {
            if (_indices.length % _stride != 0)
            {
                throw new ModelError(_document.budget.name, String(_element), "expected " + _stride + " indices for each corner, but found " +
                        _indices.length + " in all");
            }
            return _indices.length / _stride;
        }

        /** The point of a corner. The corner's indices begin at the given place. */
        private function cornerAt(place:int):uint
        {
            var value:Number = Decimal.ofIndex(_indices[int(place + _offset)]);
            var index:int = int(value);
            if (index != value || index < 0 || index >= _positions.count)
            {
                throw new ModelError(_document.budget.name, String(_element), "expected a position's index, 0 to " + (_positions.count - 1) +
                        ", but found \"" + TextTokens.shorten(_indices[place + _offset]) + "\"");
            }
            index += _positions.first;
            _isUsed[index] = 1;
            return index;
        }
    }
}
