package starlogo.steps
{
    /** Work that is done a small step at a time, so that a game goes on meanwhile. */
    public interface Steps
    {
        /**
         * Does the next step: a few milliseconds at most. It is not called again when nothing is left, nor after it has
         * thrown.
         *
         * @return whether there is more to do
         */
        function step():Boolean;
    }
}
