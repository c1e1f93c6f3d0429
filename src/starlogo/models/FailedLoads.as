package starlogo.models
{
    /** Hears why loads fail. A ModelLoader tells its receiver if that is one of these; a GreatLand is, and its errors say it. */
    public interface FailedLoads
    {
        /**
         * Called when the load of a model fails, before listeners hear of it.
         *
         * @param name the model's name
         * @param problem what is wrong, as a text
         */
        function loadFailed(name:String, problem:String):void;
    }
}
