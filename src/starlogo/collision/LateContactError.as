package starlogo.collision
{
    /** Wraps what the collision system has thrown while handlers are called, so that it is told from what a handler throws. */
    internal final class LateContactError
    {
        /** What it has thrown. */
        public var cause:*;

        public function LateContactError(cause:*)
        {
            this.cause = cause;
        }
    }
}
