package evaluation.scenes
{
    import starlogo.agents.Agent;

    /**
     * A game without players: agents, and how they move each frame. The same on every run.
     */
    public class Scene
    {
        /** What the scene is, for tables. */
        public var name:String;

        /** Its agents. */
        public var agents:Vector.<Agent> = new Vector.<Agent>();

        /**
         * For subclasses.
         *
         * @param name what the scene is
         */
        public function Scene(name:String)
        {
            this.name = name;
        }

        /** Moves the agents on by a frame. */
        public function step():void
        {
        }
    }
}
