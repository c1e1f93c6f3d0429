package starlogo.models
{
    import flash.events.Event;

    /** Tells that a ModelLoader has loaded a model: from now on agents may have its shape. */
    public class ModelEvent extends Event
    {
        /** The type of the event. */
        public static const LOADED:String = "modelLoaded";

        private var _model:Model;

        /**
         * An event of a model.
         *
         * @param type the type of the event
         * @param model the model
         */
        public function ModelEvent(type:String, model:Model)
        {
            super(type);
            _model = model;
        }

        /** The model. */
        public function get model():Model
        {
            return _model;
        }

        /** The same event, to be sent again. */
        override public function clone():Event
        {
            return new ModelEvent(type, _model);
        }
    }
}
