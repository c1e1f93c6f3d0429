package starlogo.steps
{
    /** Work that is done in small steps, so that a game can go on meanwhile. */
    public interface Steps
    {
        /**
         * Does the next step, in a few milliseconds at most. Do not call it again after it has returned false or thrown.
         *
         * @return whether there is more to do
         */
        function step():Boolean;
    }
}
