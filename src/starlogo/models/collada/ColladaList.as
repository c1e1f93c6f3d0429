package starlogo.models.collada
{
    /** The numbers or names that a COLLADA source has, as its accessor says. */
    internal final class ColladaList
    {
        /** The arrays of numbers. */
        internal static const NUMBERS:Array = ["float_array", "int_array"];

        /** The arrays of names. */
        internal static const NAMES:Array = ["Name_array", "IDREF_array"];

        /** The element with the array. */
        public var array:ColladaElement;

        /** How many entries it has. */
        public var count:int;

        /** How many words each entry has. */
        public var width:int;

        /** The words of all entries. */
        public var words:Array;

        private var _first:int; // the index in the array of the first word

        private var _numbers:Vector.<Number> = null;

        /**
         * @param source the source's element
         * @param arrays the names that its array may have
         */
        public function ColladaList(source:ColladaElement, arrays:Array)
        {
            var accessor:ColladaElement = source.requiredChild("technique_common").requiredChild("accessor");
            array = accessor.target("source", arrays, source);
            words = array.countedWords();
            array.checkCount(words.length, "values");
            var stride:Number = accessor.integer("stride", 1);
            var offset:Number = accessor.integer("offset", 0);
            accessor.refuseIf(stride == 0, "its stride is 0");
            var wanted:Number = accessor.integer("count", Math.max(0, Math.floor((words.length - offset) / stride)));
            accessor.refuseIf(offset + stride * wanted > words.length, "its count of " + wanted + " with a stride of " + stride + " reaches beyond the " +
                    words.length + " values of its array");
            count = wanted;
            width = stride;
            _first = offset;
            words = words.slice(offset, offset + stride * wanted);
        }

        /**
         * The list of an input.
         *
         * @param element has the input
         * @param semantic the input's semantic
         * @param arrays the names that the list's array may have
         * @param scope is searched for the source first
         * @throws ModelError if there is none, or it is wrong
         */
        internal static function of(element:ColladaElement, semantic:String, arrays:Array, scope:ColladaElement):ColladaList
        {
            var input:ColladaElement = element.child("input", semantic);
            element.refuseIf(input == null, "expected an <input> with the semantic " + semantic);
            return new ColladaList(input.target("source", ["source"], scope), arrays);
        }

        /** Of the numbers of the whole array, those of this list. */
        public function partOf(numbers:Vector.<Number>):Vector.<Number>
        {
            return numbers.slice(_first, _first + words.length);
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
    }
}
