package starlogo.models
{
    /** Takes in the models that a ModelLoader has read: fits structures to them, say. */
    public interface ModelReceiver
    {
        /**
         * Begins to take in a model. Nothing of it may be visible to the game before the last step is done: a load
         * may be cancelled between any two.
         *
         * @return the work that it takes, not begun yet
         */
        function receive(model:Model):Steps;
    }
}
