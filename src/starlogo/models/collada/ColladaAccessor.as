package starlogo.models.collada
{
    import starlogo.models.text.TextWords;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    /**
     * Reads the entries of a COLLADA source, in small steps: numbers, names, or points of a geometry. Its accessor says which words of an array they
     * are. All primitives of the geometry with this source share its points.
     */
    internal final class ColladaAccessor extends StepSequence
    {
        private static const POINTS_PER_STEP:int = 2000;

        /** The arrays of numbers. */
        internal static const NUMBERS:Array = ["float_array", "int_array"];

        /** The arrays of names. */
        internal static const NAMES:Array = ["Name_array", "IDREF_array"];

        /** The accessor's element. */
        public var element:ColladaElement;

        /** The element with the array. */
        public var array:ColladaElement;

        /** When all is read: the number of entries. */
        public var count:Number;

        /** When all is read: the number of words from each entry to the next one. */
        public var stride:Number;

        /** When all is read: the words of all entries. */
        public var words:Array;

        /** When all is read, if the entries are points: the index of the first one in the list of the geometry. */
        public var firstPoint:int;

        private var _firstWord:int; // its index in the array

        /**
         * @param source the source's element
         * @param arrays the names that its array may have
         * @param points takes the points, after those already present: x, y, z, ...; null if the entries are no points
         */
        public function ColladaAccessor(source:ColladaElement, arrays:Array, points:Vector.<Number> = null)
        {
            element = source.requiredChild("technique_common").requiredChild("accessor");
            array = element.target("source", arrays, source);
            var all:Array = [];
            add(TextWords.splitting(array.countedText(), all)).begin(function():Steps
                {
                    return readingEntries(all, points);
                });
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

        /** The numbers that the words stand for; a new list. @throws ModelError if one is not finite */
        public function toNumbers():Vector.<Number>
        {
            var numbers:Vector.<Number> = new Vector.<Number>();
            for each (var word:String in words)
            {
                numbers.push(array.toNumber(word));
            }
            return numbers;
        }

        // The last point may have no words after its coordinates. Returns the steps that add the points, or null.
        private function readingEntries(all:Array, points:Vector.<Number>):Steps
        {
            array.checkCount(all.length, "values");
            // the attributes may be larger than an int
            var offset:Number = element.integer("offset", 0);
            stride = element.integer("stride", 1);
            element.refuseIf(stride == 0, "its stride is 0");
            count = element.integer("count", Math.max(0, Math.floor((all.length - offset) / stride)));
            var columns:Vector.<int> = points == null ? null : columnsOf();
            var end:Number = offset + stride * (count - 1) + (points == null ? stride : 1 + Math.max(columns[0], columns[1], columns[2]));
            element.refuseIf(count > 0 && end > all.length, "its count of " + count + " with a stride of " + stride + " reaches beyond the " +
                    all.length + " values of its array");
            _firstWord = offset;
            words = all.slice(offset, offset + stride * count);
            return points == null ? null : addingPoints(points, columns);
        }

        // @param columns which words of an entry are x, y and z
        private function addingPoints(points:Vector.<Number>, columns:Vector.<int>):Steps
        {
            firstPoint = points.length / 3;
            array.budget.spendNumbers(3 * count, element);
            return new StepSequence().slices(count, POINTS_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        for (var k:int = 0; k < 3; k++)
                        {
                            points.push(array.toNumber(words[i * stride + columns[k]]));
                        }
                    }
                });
        }

        // The indices of the accessor's parameters x, y and z: found by name, otherwise the first three.
        private function columnsOf():Vector.<int>
        {
            var names:Array = [];
            element.budget.spendElements(element.children.length, element);
            for each (var param:ColladaElement in element.childrenNamed("param"))
            {
                names.push(param.attribute("name"));
            }
            var found:Vector.<int> = new <int>[names.indexOf("X"), names.indexOf("Y"), names.indexOf("Z")];
            if (found.indexOf(-1) >= 0)
            {
                found = new <int>[0, 1, 2];
            }
            element.refuseIf(names.length < 3 && names.length > 0 || Math.max(found[0], found[1], found[2]) >= stride,
                    "expected the parameters X, Y and Z of points, within its stride of " + stride);
            return found;
        }
    }
}
