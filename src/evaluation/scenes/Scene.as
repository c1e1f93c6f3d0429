package evaluation.scenes
{
    import starlogo.agents.Agent;

    /** A game without players: agents that move in every frame. It is the same on every run. */
    public class Scene
    {
        /** The scene's name in tables. */
        public var name:String;

        /** Its agents. */
        public var agents:Vector.<Agent> = new Vector.<Agent>();

        /**
         * For subclasses.
         *
         * @param name the scene's name
         */
        public function Scene(name:String)
        {
            this.name = name;
        }

        /** Moves the agents by one frame. */
        public function step():void
        {
        }
    }
}
