package starlogo.models
{
    import starlogo.steps.Steps;

    /**
     * Makes a model in steps: from a file, or in a class of the game's own from something else, for example a renderer's meshes. A
     * ModelLoader does its steps. If a step throws, the load ends.
     */
    public interface ModelMaker extends Steps
    {
        /** The model's name. */
        function get name():String;

        /** The share that is done, from 0 to 1. */
        function get progress():Number;

        /** The model. Read it when no step is left. */
        function get model():Model;
    }
}
