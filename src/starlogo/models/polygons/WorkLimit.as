package starlogo.models.polygons
{
    /**
     * How much work there may be on something that may be made to take any time.
     *
     * @private
     */
    public final class WorkLimit
    {
        /** How much was done. */
        public var done:int = 0;

        /** How much may be. */
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
