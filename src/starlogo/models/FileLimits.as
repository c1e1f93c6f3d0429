package starlogo.models
{
    /**
     * The largest numbers of vertices, triangles and other things that a file may have, and the tests of corners that cutting its polygons
     * may take. A reader asks before it reserves memory for a declared count, and before it reads or places something once more. The limits grow with the
     * bytes that are present, so time and memory are in proportion to them (docs/limits.md).
     *
     * @private
     */
    public final class FileLimits
    {
        /** The vertices of the model, with those of every instance. */
        public static const VERTICES:int = 0;

        /** The triangles of the model, with those of every instance. */
        public static const TRIANGLES:int = 1;

        /** The numbers that are read. They count as often as they are used. */
        public static const NUMBERS:int = 2;

        /** The numbers that a file has no data for, because it only declares them. */
        public static const ZEROS:int = 3;

        /** Elements, values, nodes, transforms and instances. They count as often as they are placed. */
        public static const THINGS:int = 4;

        /** Other files that are fetched. */
        public static const FILES:int = 5;

        /** The most vertices of a model. */
        public static const MOST_VERTICES:int = 1000000;

        /** The most bytes of a file. */
        public static const MOST_BYTES:int = 67108864;

        // The most tests of corners while polygons are cut: CORNER_TESTS, and TESTS_PER_BYTE more for each byte.
        private static const TESTS_PER_BYTE:Number = 40;
        private static const CORNER_TESTS:Number = 100000;

        // For each kind, from VERTICES to FILES: its name for messages; what each byte allows, what a file without bytes may have, and the most
        // that any file may have.
        private static const NAMES:Vector.<String> = new <String>["vertices", "triangles", "numbers, each counted as often as it is used",
                "numbers without data", "elements, values, nodes, transforms and instances, each counted as often as it is placed", "other files"];
        private static const PER_BYTE:Vector.<Number> = new <Number>[16, 32, 16, 1, 1, 0];
        private static const FREE:Vector.<Number> = new <Number>[100000, 200000, 100000, 0, 50000, 100];
        private static const MOST:Vector.<Number> = new <Number>[MOST_VERTICES, 2 * MOST_VERTICES, 40000000, Infinity, 500000, 100];

        /** The model's name. */
        public var modelName:String;

        private var _bytes:Number;
        private var _counts:Vector.<Number>;
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
            _counts = new Vector.<Number>(NAMES.length, true);
            _cornerTestsLeft = CORNER_TESTS + TESTS_PER_BYTE * _bytes;
        }

        /** Adds bytes that have come. */
        public function addBytes(bytes:Number):void
        {
            _bytes += bytes;
        }

        /** Counts more of a kind. @throws ModelError if these are too many */
        public function count(kind:int, more:Number, place:Object = ""):void
        {
            _counts[kind] += more;
            require(kind, _counts[kind], place);
        }

        /** Checks how many vertices and triangles the model has. @throws ModelError if there are more than a file may have */
        public function requireMesh(vertexCount:Number, triangleCount:Number, place:Object = ""):void
        {
            require(VERTICES, vertexCount, place);
            require(TRIANGLES, triangleCount, place);
        }

        /** Checks a number of a kind, without counting it. @throws ModelError if it is more than a file may have */
        public function require(kind:int, number:Number, place:Object = ""):void
        {
            var most:Number = Math.min(MOST[kind], FREE[kind] + PER_BYTE[kind] * _bytes);
            if (number > most)
            {
                throw new ModelError(modelName, String(place), "it has more than " + most + " " + NAMES[kind]);
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
