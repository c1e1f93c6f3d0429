package starlogo.models.collada
{
    import starlogo.models.Decimal;
    import starlogo.models.ModelBudget;
    import starlogo.models.refuseIf;
    import starlogo.steps.Slices;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Reads the points of a COLLADA source, in small steps. The source's accessor says which numbers of its array they are. */
    internal final class ColladaSource extends StepSequence
    {
        private static const POINTS_PER_STEP:int = 2000;

        /** The index of its first point, when no step is left. */
        public var first:int;

        /** The number of its points, when no step is left. */
        public var count:int;

        private var _document:ColladaDocument;
        private var _accessor:ColladaElement;
        private var _array:ColladaElement;
        private var _text:ColladaWords;
        private var _words:Array;
        private var _columns:Vector.<int>;
        private var _stride:int;
        private var _word:int;
        private var _points:Vector.<Number>;

        /**
         * @param document the document
         * @param source the source's element
         * @param points takes its points after those already present: x, y, z, ...
         */
        public function ColladaSource(document:ColladaDocument, source:ColladaElement, points:Vector.<Number>)
        {
            _document = document;
            _points = points;
            _accessor = document.requiredChild(document.requiredChild(source, "technique_common"), "accessor");
            _array = document.target(_accessor, "source", ["float_array", "int_array"], source);
            _text = new ColladaWords(new <ColladaElement>[_array]);
            document.budget.take(ModelBudget.NUMBERS, _text.length / 2, _accessor);
            document.budget.take(ModelBudget.THINGS, _accessor.children.length, _accessor);
            add(_text).begin(readingPoints);
        }

        private function readingPoints():Steps
        {
            _words = _text.words;
            _document.checkCount(_array, _words.length, "numbers");
            readAccessor();
            _document.budget.take(ModelBudget.NUMBERS, 3 * count, _accessor);
            first = _points.length / 3;
            return new Slices(count, POINTS_PER_STEP, readPoints);
        }

        private function readPoints(from:int, end:int):void
        {
            var x:int = _columns[0];
            var y:int = _columns[1];
            var z:int = _columns[2];
            var at:int = 3 * (first + from);
            for (var i:int = from; i < end; i++)
            {
                _points[at++] = numberAt(_word + x);
                _points[at++] = numberAt(_word + y);
                _points[at++] = numberAt(_word + z);
                _word += _stride;
            }
        }

        private function numberAt(word:int):Number
        {
            var number:Number = Decimal.of(_words[word]);
            return number - number == 0 ? number : _document.toNumber(_array, _words[word]);
        }

        private function readAccessor():void
        {
            var length:int = _words.length;
            var stride:Number = _document.integer(_accessor, "stride", 1);
            var offset:Number = _document.integer(_accessor, "offset", 0);
            _columns = columnsOf(_accessor, stride);
            var wanted:Number = _document.integer(_accessor, "count", Math.max(0, Math.floor((length - offset) / stride)));
            var last:Number = offset + stride * (wanted - 1) + Math.max(_columns[0], _columns[1], _columns[2]);
            refuseIf(wanted > 0 && last >= length, _document.modelName, "its count of " + wanted + " with a stride of " + stride +
                    " reaches beyond the " + length + " numbers of its array", _accessor);
            _stride = stride;
            _word = offset;
            count = wanted;
        }

        /** The indices of an accessor's parameters x, y and z: found by name, otherwise the first three. */
        private function columnsOf(accessor:ColladaElement, stride:Number):Vector.<int>
        {
            var names:Array = [];
            for each (var param:ColladaElement in accessor.childrenNamed("param"))
            {
                names.push(param.attribute("name"));
            }
            var columns:Vector.<int> = new <int>[names.indexOf("X"), names.indexOf("Y"), names.indexOf("Z")];
            if (columns.indexOf(-1) >= 0)
            {
                columns = new <int>[0, 1, 2];
            }
            refuseIf(names.length < 3 && names.length > 0 || Math.max(columns[0], columns[1], columns[2]) >= stride,
                    _document.modelName, "expected the parameters X, Y and Z of points, within its stride of " + stride, accessor);
            return columns;
        }
    }
}
