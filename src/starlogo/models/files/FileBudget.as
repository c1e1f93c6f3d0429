package starlogo.models.files
{
    import starlogo.models.ModelError;

    /**
     * What a file may have and cost: vertices, triangles, numbers, elements, and the tests of corners that its polygons may take. A reader
     * asks before it reserves memory for a declared count, and spends before it reads or places something once more. The budget grows with the
     * bytes that are present, so time and memory are in proportion to them (docs/limits.md).
     *
     * @private
     */
    public final class FileBudget
    {
        /** The most vertices of a model. */
        public static const MAX_VERTICES:int = 1000000;

        /** The most bytes of a file. */
        public static const MAX_BYTES:int = 67108864;

        // What a file may have if it has no bytes (FREE), what each byte allows more, and what no file may exceed. There may be twice as many triangles
        // as vertices.
        private static const FREE_VERTICES:int = 100000;
        private static const VERTICES_PER_BYTE:int = 16;
        private static const FREE_NUMBERS:int = 100000;
        private static const NUMBERS_PER_BYTE:int = 16;
        private static const MAX_NUMBERS:int = 40000000;
        private static const FREE_ELEMENTS:int = 50000;
        private static const ELEMENTS_PER_BYTE:int = 1;
        private static const MAX_ELEMENTS:int = 500000;

        // The most tests of corners while polygons are triangulated: FREE_CORNER_TESTS, and CORNER_TESTS_PER_BYTE more for each byte.
        private static const CORNER_TESTS_PER_BYTE:Number = 40;
        private static const FREE_CORNER_TESTS:Number = 100000;

        /** The model's name. */
        public var modelName:String;

        /**
         * The tests of corners that are left for triangulating polygons. If there are none, corners are cut off without a test, and holes are filled.
         * Read only.
         */
        public var cornerTestsLeft:Number;

        private var _bytes:Number;
        private var _numbers:Number;
        private var _elements:Number;

        /**
         * @param modelName the model's name
         * @param bytes the bytes or characters that are present
         */
        public function FileBudget(modelName:String, bytes:Number)
        {
            this.modelName = modelName;
            _bytes = bytes;
            reset();
        }

        /** Begins anew, because what the file has is read once more. */
        public function reset():void
        {
            _numbers = _elements = 0;
            cornerTestsLeft = FREE_CORNER_TESTS + CORNER_TESTS_PER_BYTE * _bytes;
        }

        /** Adds bytes that have come. */
        public function addBytes(bytes:Number):void
        {
            _bytes += bytes;
        }

        /** Checks how many vertices and triangles the model has, with those of every instance. @throws ModelError if there are too many */
        public function checkMeshSize(vertexCount:Number, triangleCount:Number, place:Object = ""):void
        {
            refuseBeyond(vertexCount, FREE_VERTICES, VERTICES_PER_BYTE, MAX_VERTICES, "vertices", place);
            refuseBeyond(triangleCount, 2 * FREE_VERTICES, 2 * VERTICES_PER_BYTE, 2 * MAX_VERTICES, "triangles", place);
        }

        /** Counts numbers that are read. They count as often as they are used. @throws ModelError if these are too many */
        public function spendNumbers(more:Number, place:Object):void
        {
            _numbers += more;
            refuseBeyond(_numbers, FREE_NUMBERS, NUMBERS_PER_BYTE, MAX_NUMBERS, "numbers, each counted as often as it is used", place);
        }

        /** Counts elements, values, nodes, transforms and instances, as often as they are placed. @throws ModelError if these are too many */
        public function spendElements(more:Number, place:Object):void
        {
            _elements += more;
            refuseBeyond(_elements, FREE_ELEMENTS, ELEMENTS_PER_BYTE, MAX_ELEMENTS, "elements, values, nodes, transforms and instances, each counted as often as it is placed", place);
        }

        /** Counts tests of corners. */
        public function spendCornerTests(more:int):void
        {
            cornerTestsLeft -= more;
        }

        // Checks a count against the limits named above.
        private function refuseBeyond(count:Number, free:Number, perByte:Number, most:Number, what:String, place:Object):void
        {
            var limit:Number = Math.min(most, free + perByte * _bytes);
            if (count > limit)
            {
                throw new ModelError(modelName, String(place), "it has more than " + limit + " " + what);
            }
        }
    }
}
