package starlogo.models
{
    /** How much work there may be on something that may be made to take any time. */
    internal final class WorkLimit
    {
        /** How much was done. */
        internal var done:int = 0;

        /** How much may be. */
        internal var most:int;

        /**
         * @param most how much may be done
         */
        public function WorkLimit(most:int)
        {
            this.most = most;
        }
    }
}
