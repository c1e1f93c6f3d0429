package evaluation.scenes
{
    /** The scenes for harness and tests. Each call creates a new scene, and equal arguments give equal scenes. */
    public final class Scenes
    {
        /** The names of the casts of every kind of scene. */
        public static const CASTS:Array = ["spheres", "bears", "mix"];

        /** The names of the casts of crowds: these, and the model with the most vertices, the thesis's worst case. */
        public static const CROWD_CASTS:Array = CASTS.concat("dragons");

        /** The shapes of crowded scenes, used in turn. */
        public static const CROWDED:Array = ["bear", "dragon", "fireman", "seagull", "fortress", "person"];

        private static const CROWDED_SIZE:Number = 5;

        private static const SHAPES:Object = {spheres: ["sphere"], bears: ["bear"], mix: ["bear", "sphere", "cube"], dragons: ["dragon"]};

        /**
         * The shapes of a cast's agents, used in turn.
         *
         * @throws ArgumentError if there is no such cast
         */
        public static function shapesOf(cast:String):Array
        {
            if (CROWD_CASTS.indexOf(cast) < 0)
            {
                throw new ArgumentError("the casts are " + CROWD_CASTS.join(", ") + ", not \"" + cast + "\"");
            }
            return SHAPES[cast];
        }

        /**
         * The thesis's set-up (§6.1): all agents are in one bin and collide.
         *
         * @param count the number of agents
         * @param cast one of CROWD_CASTS
         */
        public static function crowd(count:int, cast:String):Scene
        {
            return new CrowdScene(count, shapesOf(cast));
        }

        /**
         * Agents all over SpaceLand. Their size makes any number of them cover as much of the ground as a thousand agents of size 1. So
         * each agent collides equally often.
         *
         * @param count the number of agents
         * @param cast one of CASTS
         */
        public static function scatteredAsDense(count:int, cast:String):Scene
        {
            return new ScatteredScene(count, shapesOf(cast), Math.sqrt(1000 / count));
        }

        /** Agents of six models all over SpaceLand, five patches large, so that many touch. */
        public static function crowded(count:int):Scene
        {
            return new ScatteredScene(count, CROWDED, CROWDED_SIZE);
        }

        /**
         * Agents of size 1 all over SpaceLand. The more there are, the more often each collides.
         *
         * @param count the number of agents
         * @param cast one of CASTS
         */
        public static function scattered(count:int, cast:String):Scene
        {
            return new ScatteredScene(count, shapesOf(cast));
        }
    }
}
