package starlogo.steps
{
    /**
     * Work that is done in small steps, so that a game can go on meanwhile. A StepSequence is made of parts that are done one after the other,
     * for example loops over many things. <code>finish()</code> does all steps at once. Read StepSequence next.
     */
    public interface Steps
    {
        /**
         * Does the next step, in a few milliseconds at most. When no step is left, it does nothing and returns false. Do not call it again
         * after it has thrown.
         *
         * @return whether there is more to do
         */
        function step():Boolean;
    }
}
