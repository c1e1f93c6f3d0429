package starlogo.models
{
    /** Which of a COLLADA mesh's points come from one of its sources. */
    internal final class ColladaPointRange
    {
        /** The first one's index. */
        public var first:int;

        /** How many there are. */
        public var count:int;

        /**
         * @param first the first one's index
         * @param count how many there are
         */
        public function ColladaPointRange(first:int, count:int)
        {
            this.first = first;
            this.count = count;
        }
    }
}
