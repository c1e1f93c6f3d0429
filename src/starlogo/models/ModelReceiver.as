package starlogo.models
{
    import starlogo.steps.Steps;

    /** Takes the models that a ModelLoader has read. A GreatLand is one: it fits bounding structures to them. */
    public interface ModelReceiver
    {
        /** Called when a load begins. The model of this name counts as loading until expectNoMore is called for it. */
        function expect(name:String):void;

        /**
         * Called when a load ends: the model was received, the load failed, or it was cancelled. The loader's listeners hear of it later. Must not
         * throw.
         *
         * @param problem what was wrong, if the load failed; otherwise null
         */
        function expectNoMore(name:String, problem:String = null):void;

        /**
         * Returns the work that receives a model. The game may see nothing of it before the last step is done, because a load may be cancelled between
         * any two steps.
         *
         * @return the steps; none of them is done yet
         */
        function receive(model:Model):Steps;
    }
}
