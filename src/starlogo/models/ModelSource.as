package starlogo.models
{
    import starlogo.steps.Steps;

    /**
     * Makes a model in steps from something other than a file: from what a renderer has loaded, say. A ModelLoader does its steps; one that
     * throws ends the load.
     */
    public interface ModelSource extends Steps
    {
        /** The model's name. */
        function get name():String;

        /** How much is done, from 0 to 1. */
        function get progress():Number;

        /** The model, when no step is left. */
        function get model():Model;
    }
}
