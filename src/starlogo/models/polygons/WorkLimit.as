package starlogo.models.polygons
{
    /**
     * A limit to the work on input that could be made to take any time.
     *
     * @private
     */
    public final class WorkLimit
    {
        /** How much was done. */
        public var done:int = 0;

        /** How much may be done. */
        public var most:int;

        /**
         * @param most how much may be done
         */
        public function WorkLimit(most:int)
        {
            this.most = most;
        }
    }
}
