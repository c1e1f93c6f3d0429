package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.steps.Steps;

    /** A receiver that takes what was computed for a model when the game was built: a GreatLand. A ModelLoader fetches it for one. */
    public interface FitsReceiver extends ModelReceiver
    {
        /**
         * Begins to take in a model, as <code>receive()</code> does.
         *
         * @param model the model
         * @param baked what may be its .fits file; null where there is none. It may as well be damaged, old or something else
         * @return the work that it takes, not begun yet
         */
        function receiveWithFits(model:Model, baked:ByteArray):Steps;
    }
}
