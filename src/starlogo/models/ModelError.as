package starlogo.models
{
    /**
     * Thrown when a model can't be loaded: its message says which model, where in the file, and what is wrong with it.
     */
    public class ModelError extends Error
    {
        private var _modelName:String;
        private var _place:String;

        /**
         * An error that says which model, where and what.
         *
         * @param modelName the model's name as it was given
         * @param place where in the file: "line 12", or an element's path; "" where it has no place
         * @param problem what is wrong, and what was expected
         */
        public function ModelError(modelName:String, place:String, problem:String)
        {
            super("model \"" + modelName + "\"" + (place == "" ? "" : ", " + place) + ": " + problem);
            name = "ModelError";
            _modelName = modelName;
            _place = place;
        }

        /** The name of the model that failed. */
        public function get modelName():String
        {
            return _modelName;
        }

        /** Where in the file: "line 12" or an element's path; "" where it has no place. */
        public function get place():String
        {
            return _place;
        }
    }
}
