package starlogo.models
{
    import starlogo.steps.Steps;

    /** Takes in the models that a ModelLoader has read: fits structures to them, say. */
    public interface ModelReceiver
    {
        /** Tells that a model of a name is to be loaded: from when it is asked for until expectNoMore is called for it. */
        function expect(name:String):void;

        /** Tells that one model of a name is not on its way any more: it is taken in, it failed, or it was cancelled. */
        function expectNoMore(name:String):void;

        /**
         * Begins to take in a model. Nothing of it may be visible to the game before the last step is done: a load
         * may be cancelled between any two.
         *
         * @return the work that it takes, not begun yet
         */
        function receive(model:Model):Steps;
    }
}
