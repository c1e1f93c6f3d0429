package growth
{
    /** A row of the table of `./antw growth`: something that can be made in any size, and whose cost is measured. */
    public final class GrowthRow
    {
        /** The largest exponent of a cost that is n log n. From 2,000 to 8,000, n log n has 1.08; the rest is for the clock. */
        public static const MOST:Number = 1.3;

        /** The largest exponent of a cost that must not grow at all. */
        public static const CONSTANT:Number = 0.3;

        /** The largest exponent of a cost that docs/limits.md admits to be quadratic. */
        public static const QUADRATIC:Number = 2.3;

        /** Its name. */
        public var name:String;

        /** What n counts. */
        public var grows:String;

        /** The smallest n that is measured. */
        public var least:int;

        /** The n to begin with: <code>least</code>, or more. */
        public var start:int;

        /** The largest n that is measured. */
        public var most:int;

        /** The largest exponent that its cost may have. */
        public var exponent:Number = MOST;

        /** The bytes of the last file that begin() has made; 0 if the row reads no file. */
        public var bytes:int = 0;

        private var _begin:Function;

        /**
         * @param name its name; the word before the first ":" says where it belongs
         * @param grows what n counts
         * @param least the smallest n
         * @param most the largest n
         * @param begin <code>function(n:int, row:GrowthRow):Function</code>: prepares a run, which is not measured, and returns a
         * <code>function():Object</code>, which is measured. Its result is kept until the memory is read
         */
        public function GrowthRow(name:String, grows:String, least:int, most:int, begin:Function)
        {
            this.name = name;
            this.grows = grows;
            this.least = start = least;
            this.most = most;
            _begin = begin;
        }

        /** Prepares a run and returns the function that is measured. */
        public function begin(n:int):Function
        {
            return _begin(n, this);
        }

        /**
         * Says that the measurement begins with a larger n, because small ones say nothing of the growth. For example, a file may repeat some
         * things freely, however small it is (FileBudget). The cost of repeating grows with n * n until these are used up. Returns the row.
         */
        public function from(n:int):GrowthRow
        {
            start = n;
            return this;
        }

        /** Says that the cost must not grow with n at all, for example because n is only declared. Returns the row. */
        public function staying():GrowthRow
        {
            exponent = CONSTANT;
            return this;
        }

        /** Says that the cost grows with n * n, and that docs/limits.md gives the reason. Returns the row. */
        public function admitted():GrowthRow
        {
            exponent = QUADRATIC;
            return this;
        }
    }
}
