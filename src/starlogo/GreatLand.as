package starlogo
{
    import starlogo.agents.Agent;
    import starlogo.models.Model;

    use namespace engine;

    /**
     * What a game has loaded: its models.
     */
    public class GreatLand
    {
        private var _models:Object = {};

        /** A game without models. */
        public function GreatLand()
        {
        }

        /**
         * Adds a model, or replaces the one of its name.
         *
         * @param model has the name that agents have as their shape
         * @throws ArgumentError if it is null
         */
        public function addModel(model:Model):void
        {
            if (model == null)
            {
                throw new ArgumentError("model must not be null");
            }
            _models[model.name] = model;
        }

        /** Whether a model of this name was added. */
        public function hasModel(name:String):Boolean
        {
            return _models.hasOwnProperty(name);
        }

        /**
         * @private
         */
        engine function requireModel(agent:Agent):void
        {
            if (!hasModel(agent.shape))
            {
                throw new ArgumentError(agent + ": there is no model \"" + agent.shape + "\"; add it to the GreatLand first");
            }
        }
    }
}
