package starlogo.models
{
    import starlogo.steps.Slices;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads one element of a COLLADA mesh that carries surfaces: triangles, polylist, polygons, tristrips or trifans.
     */
    internal final class ColladaPrimitive implements Steps
    {
        private static const CORNERS_PER_STEP:int = 1500;
        private static const SIZES_PER_STEP:int = 5000;
        private static const MAX_OFFSET:int = 255;
        private static const NAMES:Array = ["triangles", "polylist", "polygons", "tristrips", "trifans"];

        private var _document:ColladaDocument;
        private var _element:ColladaElement;
        private var _firstPosition:int;
        private var _positionCount:int;
        private var _isUsed:Vector.<uint>;
        private var _triangles:Vector.<uint>;
        private var _triangulator:Triangulator;

        // where corners find their position's index: every _stride words, from the word _offset
        private var _stride:int;
        private var _offset:int;

        // the lists of corners (p or ph), and how far they and the present one are read
        private var _lists:Vector.<ColladaElement>;
        private var _list:int = 0;
        private var _text:ColladaWords = null;
        private var _words:Array = [];
        private var _word:int = 0;

        // of a polylist: how many corners each polygon has
        private var _vcount:ColladaElement;
        private var _sizeText:ColladaWords = null;
        private var _sizes:Array = null;
        private var _size:int = 0;
        private var _sum:Number = 0;

        private var _work:StepSequence = new StepSequence();

        /**
         * @param document the document
         * @param element the primitive
         * @param positions its points, which are read
         * @param isUsed a number for each point of the mesh; set to 1 where a corner is
         * @param triangles where the triangles go
         * @param triangulator cuts the polygons, into the same triangles
         */
        public function ColladaPrimitive(document:ColladaDocument, element:ColladaElement, positions:ColladaSource,
                isUsed:Vector.<uint>, triangles:Vector.<uint>, triangulator:Triangulator)
        {
            _document = document;
            _element = element;
            _firstPosition = positions.first;
            _positionCount = positions.count;
            _isUsed = isUsed;
            _triangles = triangles;
            _triangulator = triangulator;
            _lists = element.childrenNamed("p");
            readInputs();
            plan();
        }

        /** Whether an element is a primitive with surfaces; some programs write empty ones, without inputs. */
        internal static function isSurface(element:ColladaElement):Boolean
        {
            return NAMES.indexOf(element.name) >= 0 && element.attribute("count") != "0";
        }

        /**
         * The input of a primitive that places its corners.
         *
         * @throws ModelError if there is none
         */
        internal static function positionInput(document:ColladaDocument, element:ColladaElement):ColladaElement
        {
            var position:ColladaElement = null;
            for each (var input:ColladaElement in element.childrenNamed("input"))
            {
                if (input.attribute("semantic") == "VERTEX")
                {
                    return input;
                }
                if (input.attribute("semantic") == "POSITION")
                {
                    position = input;
                }
            }
            if (position == null)
            {
                throw document.error(element, "expected an <input> with the semantic VERTEX");
            }
            return position;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            return _work.step();
        }

        private function readInputs():void
        {
            _stride = 1;
            for each (var input:ColladaElement in _element.childrenNamed("input"))
            {
                var offset:Number = _document.integer(input, "offset", 0);
                if (offset > MAX_OFFSET)
                {
                    throw _document.error(input, "expected an offset of at most " + MAX_OFFSET + ", but found " + offset);
                }
                _stride = Math.max(_stride, offset + 1);
            }
            _offset = _document.integer(positionInput(_document, _element), "offset", 0);
        }

        private function plan():void
        {
            switch (_element.name)
            {
                case "triangles":
                    _text = new ColladaWords(_lists);
                    _work.add(_text).call(checkTriangles).repeat(readTriangles);
                    break;
                case "polylist":
                    _text = new ColladaWords(_lists);
                    _vcount = _element.child("vcount");
                    _sizeText = new ColladaWords(_element.childrenNamed("vcount").slice(0, 1));
                    _work.add(_text).add(_sizeText).begin(checkSizes).call(checkSum).repeat(function():Boolean
                        {
                            return cutOr(readPolylist);
                        });
                    break;
                case "polygons":
                    _lists = _lists.concat(_element.childrenNamed("ph"));
                    _document.checkCount(_element, _lists.length, "polygons");
                    _work.repeat(function():Boolean
                        {
                            return cutOr(readPolygons);
                        });
                    break;
                default:
                    _document.checkCount(_element, _lists.length, "lists of corners <p>");
                    _work.repeat(readStrips);
                    break;
            }
        }

        private function checkTriangles():void
        {
            takeWords();
            if (cornersIn(_words) % 3 != 0)
            {
                throw _document.error(_element, "expected three corners for each triangle, but found " +
                        cornersIn(_words));
            }
            _document.checkCount(_element, cornersIn(_words) / 3, "triangles");
        }

        private function takeWords():void
        {
            _words = _text.all;
            _text = null;
        }

        private function checkSizes():Steps
        {
            takeWords();
            _sizes = _sizeText.all;
            _sizeText = null;
            _document.checkCount(_element, _sizes.length, "numbers in <vcount>");
            return new Slices(_sizes.length, SIZES_PER_STEP, addSizes);
        }

        private function addSizes(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var size:Number = Number(_sizes[i]);
                if (!(size >= 0 && size <= _words.length && size == int(size)))
                {
                    throw _document.error(_vcount, "expected how many corners a polygon has, but found \"" +
                            TextTokens.shorten(_sizes[i]) + "\"");
                }
                _sum += size;
            }
        }

        private function checkSum():void
        {
            if (_sum != cornersIn(_words))
            {
                throw _document.error(_element, "its <vcount> adds up to " + _sum + " corners, but <p> has " +
                        cornersIn(_words));
            }
        }

        // A polygon of many corners is cut in steps, before the next ones are read.
        private function cutOr(read:Function):Boolean
        {
            if (_triangulator.isCutting)
            {
                _triangulator.cutSome();
            }
            else
            {
                read();
            }
            return _triangulator.isCutting || hasMore;
        }

        private function cornersIn(words:Array):int
        {
            if (words.length % _stride != 0)
            {
                throw _document.error(_element, "expected " + _stride + " indices for each corner, but found " +
                        words.length + " in all");
            }
            return words.length / _stride;
        }

        private function readTriangles():Boolean
        {
            var end:int = Math.min(_words.length, _word + CORNERS_PER_STEP * _stride);
            var at:int = _triangles.length;
            while (_word < end)
            {
                _triangles[at++] = cornerAt(_word);
                _word += _stride;
            }
            return _word < _words.length;
        }

        // Of polygons.
        private function get hasMore():Boolean
        {
            return _sizes == null ? _list < _lists.length : _size < _sizes.length;
        }

        private function readPolylist():void
        {
            var end:int = _word + CORNERS_PER_STEP * _stride;
            while (_size < _sizes.length && _word <= end && !_triangulator.isCutting)
            {
                var count:int = Number(_sizes[_size++]);
                if (count == 4)
                {
                    _triangulator.addQuad(cornerAt(_word), cornerAt(_word + _stride), cornerAt(_word + 2 * _stride),
                            cornerAt(_word + 3 * _stride));
                }
                else if (count > 2)
                {
                    _triangulator.addPolygon(new <Vector.<uint>>[corners(_words, _word, count)]);
                }
                _word += count * _stride;
            }
        }

        private function readPolygons():void
        {
            var read:int = 0;
            while (read < CORNERS_PER_STEP && _list < _lists.length && !_triangulator.isCutting)
            {
                var element:ColladaElement = _lists[_list++];
                var loops:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
                if (element.name == "ph")
                {
                    loops.push(loopOf(_document.requiredChild(element, "p")));
                    for each (var hole:ColladaElement in element.childrenNamed("h"))
                    {
                        loops.push(loopOf(hole));
                    }
                }
                else
                {
                    loops.push(loopOf(element));
                }
                read += 10 + loops[0].length;
                if (loops[0].length > 2)
                {
                    _triangulator.addPolygon(loops);
                }
            }
        }

        private function readStrips():Boolean
        {
            var isFan:Boolean = _element.name == "trifans";
            var read:int = 0;
            while (read < CORNERS_PER_STEP && _list < _lists.length)
            {
                var strip:Vector.<uint> = loopOf(_lists[_list++]);
                for (var i:int = 2; i < strip.length; i++)
                {
                    var first:uint = isFan ? strip[0] : strip[i - 2 + (i & 1)];
                    var second:uint = isFan ? strip[i - 1] : strip[i - 1 - (i & 1)];
                    if (first != second && second != strip[i] && strip[i] != first)
                    {
                        _triangles.push(first, second, strip[i]);
                    }
                }
                read += 10 + strip.length;
            }
            return _list < _lists.length;
        }

        private function loopOf(element:ColladaElement):Vector.<uint>
        {
            _words = element.words;
            return corners(_words, 0, cornersIn(_words));
        }

        private function corners(words:Array, start:int, count:int):Vector.<uint>
        {
            var result:Vector.<uint> = new Vector.<uint>(count);
            for (var i:int = 0; i < count; i++)
            {
                result[i] = cornerAt(start + i * _stride);
            }
            return result;
        }

        /** The point of the corner whose indices begin at a word. */
        private function cornerAt(word:int):uint
        {
            var value:Number = Number(_words[int(word + _offset)]);
            var index:int = int(value);
            if (index != value || index < 0 || index >= _positionCount)
            {
                throw _document.error(_element, "expected a position's index, 0 to " + (_positionCount - 1) +
                        ", but found \"" + TextTokens.shorten(_words[word + _offset]) + "\"");
            }
            index += _firstPosition;
            _isUsed[index] = 1;
            return index;
        }
    }
}
