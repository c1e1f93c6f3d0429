package starlogo.models.collada
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    /** Reads the entries of a COLLADA source, in small steps: numbers or names. Its accessor says which words of an array they are. */
    internal final class ColladaAccessor extends StepSequence
    {
        /** The arrays of numbers. */
        internal static const NUMBERS:Array = ["float_array", "int_array"];

        /** The arrays of names. */
        internal static const NAMES:Array = ["Name_array", "IDREF_array"];

        /** The accessor's element. */
        public var element:ColladaElement;

        /** The element with the array. */
        public var array:ColladaElement;

        /** When all is read: the number of entries. */
        public var count:int;

        /** When all is read: the number of words from each entry to the next one. */
        public var stride:int;

        /** When all is read: the words of all entries. */
        public var words:Array;

        /** When all is read: which words of an entry are x, y and z. Null if the entries are no points. */
        public var columns:Vector.<int> = null;

        private var _firstWord:int; // its index in the array
        private var _numbers:Vector.<Number> = null;

        /**
         * @param source the source's element
         * @param arrays the names that its array may have
         * @param arePoints whether the entries are points. Then the last one may have no words after its coordinates
         */
        public function ColladaAccessor(source:ColladaElement, arrays:Array, arePoints:Boolean = false)
        {
            element = source.requiredChild("technique_common").requiredChild("accessor");
            array = element.target("source", arrays, source);
            add(array.splittingText(function(all:Array):Steps
                    {
                        readEntries(all, arePoints);
                        return null;
                    }));
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

        private function readEntries(all:Array, arePoints:Boolean):void
        {
            array.checkCount(all.length, "values");
            // the attributes may be larger than an int
            var wantedStride:Number = element.integer("stride", 1);
            var offset:Number = element.integer("offset", 0);
            element.refuseIf(wantedStride == 0, "its stride is 0");
            columns = arePoints ? columnsOf(wantedStride) : null;
            var wanted:Number = element.integer("count", Math.max(0, Math.floor((all.length - offset) / wantedStride)));
            var end:Number = offset + wantedStride * (wanted - 1) + (arePoints ? 1 + Math.max(columns[0], columns[1], columns[2]) : wantedStride);
            element.refuseIf(wanted > 0 && end > all.length, "its count of " + wanted + " with a stride of " + wantedStride + " reaches beyond the " +
                    all.length + " values of its array");
            count = wanted;
            stride = wantedStride;
            _firstWord = offset;
            words = all.slice(offset, offset + wantedStride * wanted);
        }

        // The indices of the accessor's parameters x, y and z: found by name, otherwise the first three.
        private function columnsOf(wantedStride:Number):Vector.<int>
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
            element.refuseIf(names.length < 3 && names.length > 0 || Math.max(found[0], found[1], found[2]) >= wantedStride,
                    "expected the parameters X, Y and Z of points, within its stride of " + wantedStride);
            return found;
        }
    }
}
