package starlogo.models.collada
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    /** Reads the entries of a COLLADA source, in small steps: numbers, names or points. Its accessor says which words of an array they are. */
    internal final class ColladaAccessor extends StepSequence
    {
        /** The arrays of numbers. */
        internal static const NUMBERS:Array = ["float_array", "int_array"];

        /** The arrays of names. */
        internal static const NAMES:Array = ["Name_array", "IDREF_array"];

        private static const POINTS_PER_STEP:int = 2000;

        /** The element with the array. */
        public var array:ColladaElement;

        /** When all is read: the number of entries. */
        public var count:int;

        /** When all is read: how many words each entry has. */
        public var width:int;

        /** When all is read: the words of all entries, unless they are points. */
        public var words:Array;

        /** When all is read: the index of the first point. */
        public var firstPoint:int;

        private var _accessor:ColladaElement;
        private var _points:Vector.<Number>;
        private var _firstWord:int; // its index in the array
        private var _numbers:Vector.<Number> = null;

        /**
         * @param source the source's element
         * @param arrays the names that its array may have
         * @param points takes the entries as points, after those already present: x, y, z, ... Null if they are no points
         */
        public function ColladaAccessor(source:ColladaElement, arrays:Array, points:Vector.<Number> = null)
        {
            _accessor = source.requiredChild("technique_common").requiredChild("accessor");
            _points = points;
            array = _accessor.target("source", arrays, source);
            add(array.splittingText(readingEntries));
        }

        /**
         * Reads the entries of an input at once.
         *
         * @param element has the input
         * @param semantic the input's semantic
         * @param arrays the names that the array may have
         * @param scope is searched for the source first
         * @throws ModelError if there is none, or it is wrong
         */
        internal static function read(element:ColladaElement, semantic:String, arrays:Array, scope:ColladaElement):ColladaAccessor
        {
            var accessor:ColladaAccessor = new ColladaAccessor(element.requiredInput(semantic).target("source", ["source"], scope), arrays);
            finish(accessor);
            return accessor;
        }

        /** Of the numbers of the whole array, those of the entries. */
        public function partOf(numbers:Vector.<Number>):Vector.<Number>
        {
            return numbers.slice(_firstWord, _firstWord + words.length);
        }

        /** The numbers that the words stand for. @throws ModelError if one is not finite */
        public function get numbers():Vector.<Number>
        {
            if (_numbers == null)
            {
                _numbers = new Vector.<Number>();
                for each (var word:String in words)
                {
                    _numbers.push(array.toNumber(word));
                }
            }
            return _numbers;
        }

        private function readingEntries(all:Array):Steps
        {
            array.checkCount(all.length, "values");
            var stride:Number = _accessor.integer("stride", 1);
            var offset:Number = _accessor.integer("offset", 0);
            _accessor.refuseIf(stride == 0, "its stride is 0");
            var columns:Vector.<int> = _points == null ? null : columnsOf(stride);
            var wanted:Number = _accessor.integer("count", Math.max(0, Math.floor((all.length - offset) / stride)));
            // the last point need not have the words after its coordinates
            var end:Number = offset + stride * (wanted - 1) + (columns == null ? stride : 1 + Math.max(columns[0], columns[1], columns[2]));
            _accessor.refuseIf(wanted > 0 && end > all.length, "its count of " + wanted + " with a stride of " + stride + " reaches beyond the " +
                    all.length + " values of its array");
            count = wanted;
            width = stride;
            _firstWord = offset;
            if (columns != null)
            {
                return readingPoints(all, columns);
            }
            words = all.slice(offset, offset + stride * wanted);
            return null;
        }

        // The indices of the accessor's parameters x, y and z: found by name, otherwise the first three.
        private function columnsOf(stride:Number):Vector.<int>
        {
            var names:Array = [];
            _accessor.limits.spendElements(_accessor.children.length, _accessor);
            for each (var param:ColladaElement in _accessor.childrenNamed("param"))
            {
                names.push(param.attribute("name"));
            }
            var columns:Vector.<int> = new <int>[names.indexOf("X"), names.indexOf("Y"), names.indexOf("Z")];
            if (columns.indexOf(-1) >= 0)
            {
                columns = new <int>[0, 1, 2];
            }
            _accessor.refuseIf(names.length < 3 && names.length > 0 || Math.max(columns[0], columns[1], columns[2]) >= stride,
                    "expected the parameters X, Y and Z of points, within its stride of " + stride);
            return columns;
        }

        private function readingPoints(all:Array, columns:Vector.<int>):Steps
        {
            array.limits.spendNumbers(3 * count, _accessor);
            firstPoint = _points.length / 3;
            return new StepSequence().slices(count, POINTS_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        for (var k:int = 0; k < 3; k++)
                        {
                            _points[3 * (firstPoint + i) + k] = array.toNumber(all[_firstWord + i * width + columns[k]]);
                        }
                    }
                });
        }
    }
}
