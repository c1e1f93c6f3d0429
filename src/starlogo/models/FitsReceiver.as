package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.steps.Steps;

    /**
     * A receiver that also takes the .fits files that were computed when the game was built, like a GreatLand. A ModelLoader fetches them for such
     * a receiver.
     */
    public interface FitsReceiver extends ModelReceiver
    {
        /**
         * Begins to take in a model, as <code>receive()</code> does.
         *
         * @param model the model
         * @param baked the bytes of its .fits file, which may be damaged, old or something else; null where there is none
         * @return the work that it takes, not begun yet
         */
        function receiveWithFits(model:Model, baked:ByteArray):Steps;
    }
}
