package starlogo.models
{
    import starlogo.steps.Steps;

    /** Receives the models that a ModelLoader has read: fits structures to them, say. */
    public interface ModelReceiver
    {
        /** Tells that a model of a name is being loaded, until expectNoMore is called for it. */
        function expect(name:String):void;

        /** Tells that one load of a model of a name has ended: the model was received, the load failed, or it was cancelled. */
        function expectNoMore(name:String):void;

        /**
         * Begins to receive a model. Nothing of it may be visible to the game before the last step is done: a load may be cancelled between any two
         * steps.
         *
         * @return the work that it takes, not begun yet
         */
        function receive(model:Model):Steps;
    }
}
