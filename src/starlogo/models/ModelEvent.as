package starlogo.models
{
    import flash.events.Event;

    /** Sent when a ModelLoader has loaded a model. From now on agents that have its shape collide. */
    public class ModelEvent extends Event
    {
        /** Sent when a model is loaded. */
        public static const LOADED:String = "modelLoaded";

        private var _model:Model;

        /**
         * Creates an event.
         *
         * @param type the type of the event
         * @param model the model that was loaded
         */
        public function ModelEvent(type:String, model:Model)
        {
            super(type);
            _model = model;
        }

        /** The model that was loaded. */
        public function get model():Model
        {
            return _model;
        }

        /** Copies the event, so that it can be sent again. */
        override public function clone():Event
        {
            return new ModelEvent(type, _model);
        }

        /** Its type and its model, as text. */
        override public function toString():String
        {
            return formatToString("ModelEvent", "type", "model");
        }
    }
}
