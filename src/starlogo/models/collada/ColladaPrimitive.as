package starlogo.models.collada
{
    import starlogo.models.polygons.Triangulator;
    import starlogo.models.text.TextWords;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads one primitive with a surface of a COLLADA geometry, in small steps: triangles, polylist, polygons, tristrips or trifans.
     */
    internal final class ColladaPrimitive extends StepSequence
    {
        private static const CORNERS_PER_STEP:int = 1500;

        private var _element:ColladaElement;
        private var _points:ColladaAccessor;
        private var _triangulator:Triangulator;

        // A corner takes _stride indices. The one at _offset is its position's.
        private var _stride:int;
        private var _offset:int;

        /**
         * @param element the primitive's element
         * @param points its points; their steps come before this one's
         * @param triangulator takes the triangles and the polygons
         */
        public function ColladaPrimitive(element:ColladaElement, points:ColladaAccessor, triangulator:Triangulator)
        {
            _element = element;
            _points = points;
            _triangulator = triangulator;
            _stride = element.inputStride();
            _offset = positionInput(element).integer("offset", 0);
            var lists:Vector.<ColladaElement> = element.childrenNamed("p");
            switch (element.name)
            {
                case "triangles":
                    addIndexed(lists, readingTriangles);
                    break;
                case "polylist":
                    addIndexed(lists, readingPolylist);
                    break;
                case "polygons":
                    addLists(lists.concat(element.childrenNamed("ph")), "polygons", readPolygon);
                    break;
                default:
                    addLists(lists, "lists of corners <p>", readStrip);
            }
        }

        /** The input with the positions of a primitive's corners. */
        internal static function positionInput(element:ColladaElement):ColladaElement
        {
            var input:ColladaElement = element.child("input", "VERTEX") || element.child("input", "POSITION");
            element.refuseIf(input == null, "expected an <input> with the semantic VERTEX");
            return input;
        }

        // Reads all lists of corners as one. @param read <code>function(indices:Array):Steps</code>; the work on their indices
        private function addIndexed(lists:Vector.<ColladaElement>, read:Function):void
        {
            var texts:Array = [];
            var indices:Array = [];
            for each (var list:ColladaElement in lists)
            {
                texts.push(list.text);
            }
            add(TextWords.splitting(texts.join(" "), indices)).begin(function():Steps
                {
                    return read(indices);
                });
        }

        private function readingTriangles(indices:Array):Steps
        {
            var count:int = cornersIn(indices);
            _element.refuseIf(count % 3 != 0, "expected three corners for each triangle, but found " + count);
            _element.checkCount(count / 3, "triangles");
            return new StepSequence().slices(count, CORNERS_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        _triangulator.triangles.push(readCorner(indices, i * _stride));
                    }
                });
        }

        // A polylist has the indices of all polygons in one list, and the number of corners of each polygon in another.
        private function readingPolylist(indices:Array):Steps
        {
            var vcount:ColladaElement = _element.child("vcount");
            var sizes:Array = [];
            var corners:int = cornersIn(indices);
            var next:int = 0;
            return new StepSequence().add(TextWords.splitting(vcount == null ? "" : vcount.text, sizes)).begin(function():Steps
                {
                    _element.checkCount(sizes.length, "numbers in <vcount>");
                    return new StepSequence().beginEach(sizes.length, function(index:int):Steps
                        {
                            var first:int = next;
                            var count:int = vcount.toInteger(sizes[index], 0, corners - first, "the number of a polygon's corners");
                            next += count;
                            return count > 2 ? _triangulator.addPolygon(readCorners(indices, first * _stride, count)) : null;
                        }, Triangulator.POLYGONS_PER_STEP);
                }).call(function():void
                {
                    _element.refuseIf(next != corners, "its <vcount> adds up to " + next + " corners, but <p> has " + corners);
                });
        }

        // Each list of corners is read at once. @param read <code>function(list:ColladaElement):Steps</code>; adds the triangles, or returns the work on the rest
        private function addLists(lists:Vector.<ColladaElement>, what:String, read:Function):void
        {
            _element.checkCount(lists.length, what);
            beginEach(lists.length, function(index:int):Steps
                {
                    return read(lists[index]);
                }, Triangulator.POLYGONS_PER_STEP);
        }

        // Reads a polygon (p), or one with holes (ph).
        private function readPolygon(list:ColladaElement):Steps
        {
            var hasHoles:Boolean = list.name == "ph";
            var outline:Vector.<uint> = readLoop(hasHoles ? list.requiredChild("p") : list);
            var holes:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
            for each (var hole:ColladaElement in hasHoles ? list.childrenNamed("h") : null)
            {
                holes.push(readLoop(hole));
            }
            return _triangulator.addPolygon(outline, holes);
        }

        // Reads a strip or a fan of triangles.
        private function readStrip(list:ColladaElement):Steps
        {
            var isFan:Boolean = _element.name == "trifans";
            var strip:Vector.<uint> = readLoop(list);
            for (var i:int = 2; i < strip.length; i++)
            {
                var first:int = isFan ? 0 : i - 2 + (i & 1);
                var second:int = isFan ? i - 1 : i - 1 - (i & 1);
                _triangulator.addTriangle(strip[first], strip[second], strip[i]);
            }
            return null;
        }

        private function readLoop(list:ColladaElement):Vector.<uint>
        {
            var indices:Array = TextWords.of(list.text);
            return readCorners(indices, 0, cornersIn(indices));
        }

        // Reads some corners, whose indices begin at the first one given.
        private function readCorners(indices:Array, first:int, count:int):Vector.<uint>
        {
            var corners:Vector.<uint> = new Vector.<uint>(count);
            for (var i:int = 0; i < count; i++)
            {
                corners[i] = readCorner(indices, first + i * _stride);
            }
            return corners;
        }

        // The number of corners that some indices are for.
        private function cornersIn(indices:Array):int
        {
            if (indices.length % _stride != 0)
            {
                throw _element.error("expected " + _stride + " indices for each corner, but found " + indices.length + " in all");
            }
            return indices.length / _stride;
        }

        // Reads a corner, whose indices begin at the given one. Returns its point.
        private function readCorner(indices:Array, at:int):uint
        {
            return _points.firstPoint + _element.toInteger(indices[int(at + _offset)], 0, _points.count - 1, "a position's index");
        }
    }
}
