package starlogo.models.building
{
    import starlogo.models.ModelError;

    /**
     * The largest numbers of vertices, triangles and other things that a file may have, and the tests of corners that cutting its polygons
     * may take. A reader asks before it reserves memory for a declared count, and before it reads or places something once more. The limits grow with the
     * bytes that are present, so time and memory are in proportion to them (docs/limits.md).
     *
     * @private
     */
    public final class FileLimits
    {
        /** The most vertices of a model. */
        public static const MOST_VERTICES:int = 1000000;

        /** The most bytes of a file. */
        public static const MOST_BYTES:int = 67108864;

        // The most tests of corners while polygons are cut: CORNER_TESTS, and TESTS_PER_BYTE more for each byte.
        private static const TESTS_PER_BYTE:Number = 40;
        private static const CORNER_TESTS:Number = 100000;

        /** The model's name. */
        public var modelName:String;

        private var _bytes:Number;
        private var _numbers:Number;
        private var _zeros:Number;
        private var _elements:Number;
        private var _cornerTestsLeft:Number;

        /**
         * @param modelName the model's name
         * @param bytes the bytes or characters that are present
         */
        public function FileLimits(modelName:String, bytes:Number)
        {
            this.modelName = modelName;
            _bytes = bytes;
            restart();
        }

        /** Counts anew, because what the file has is read once more. */
        public function restart():void
        {
            _numbers = _zeros = _elements = 0;
            _cornerTestsLeft = CORNER_TESTS + TESTS_PER_BYTE * _bytes;
        }

        /** Adds bytes that have come. */
        public function addBytes(bytes:Number):void
        {
            _bytes += bytes;
        }

        /** Checks how many vertices and triangles the model has, with those of every instance. @throws ModelError if there are too many */
        public function requireMesh(vertexCount:Number, triangleCount:Number, place:Object = ""):void
        {
            require(vertexCount, 100000, 16, MOST_VERTICES, "vertices", place);
            require(triangleCount, 200000, 32, 2 * MOST_VERTICES, "triangles", place);
        }

        /** Counts numbers that are read. They count as often as they are used. @throws ModelError if these are too many */
        public function countNumbers(more:Number, place:Object):void
        {
            _numbers += more;
            require(_numbers, 100000, 16, 40000000, "numbers, each counted as often as it is used", place);
        }

        /** Counts numbers that a file declares without data, so they are 0. @throws ModelError if these are too many */
        public function countZeros(more:Number, place:Object):void
        {
            _zeros += more;
            require(_zeros, 0, 1, Infinity, "numbers without data", place);
        }

        /** Counts elements, values, nodes, transforms and instances, as often as they are placed. @throws ModelError if these are too many */
        public function countElements(more:Number, place:Object):void
        {
            _elements += more;
            require(_elements, 50000, 1, 500000, "elements, values, nodes, transforms and instances, each counted as often as it is placed", place);
        }

        // Checks a count. A file without bytes may have as many as are free, each byte allows some more, and no file may have more than the most.
        private function require(count:Number, free:Number, perByte:Number, most:Number, what:String, place:Object):void
        {
            var limit:Number = Math.min(most, free + perByte * _bytes);
            if (count > limit)
            {
                throw new ModelError(modelName, String(place), "it has more than " + limit + " " + what);
            }
        }

        /** The tests of corners that are left for cutting polygons. If there are none, corners are cut off without a test, and holes are filled. */
        public function get cornerTestsLeft():Number
        {
            return _cornerTestsLeft;
        }

        /** Counts tests of corners. */
        public function countCornerTests(more:int):void
        {
            _cornerTestsLeft -= more;
        }
    }
}
