package starlogo.models
{
    import starlogo.models.files.shortened;

    /** Thrown if a model can't be loaded. The message says which model, where in the file, and what is wrong. */
    public class ModelError extends Error
    {
        private var _modelName:String;
        private var _place:String;

        /**
         * Creates an error for a place in a model's file.
         *
         * @param modelName the model's name as it was given
         * @param place where in the file: "line 12", or an element's path; "" if the error has no place
         * @param problem what is wrong, and what was expected
         */
        public function ModelError(modelName:String, place:String, problem:String)
        {
            super("model \"" + shortened(modelName) + "\"" + (place == "" ? "" : ", " + place) + ": " + problem + (isText(modelName) ? "; a model's name comes before its text" : ""));
            name = "ModelError";
            _modelName = isText(modelName) ? shortened(modelName) : modelName;
            _place = place;
        }

        // Whether a text of several lines was passed in place of a name.
        private static function isText(name:String):Boolean
        {
            return name != null && name.indexOf("\n") >= 0;
        }

        /** The name of the model that failed. If it was a text of several lines, its beginning. */
        public function get modelName():String
        {
            return _modelName;
        }

        /** Where in the file: "line 12" or an element's path; "" if the error has no place. */
        public function get place():String
        {
            return _place;
        }
    }
}
