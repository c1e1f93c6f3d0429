package evaluation.scenes
{
    /**
     * The scenes that harness and tests play, by what is in them; each call makes a new one that is the same as the last.
     */
    public final class Scenes
    {
        /** The names of the casts. */
        public static const CASTS:Array = ["spheres", "bears", "mix"];

        private static const SHAPES:Object = {spheres: ["sphere"], bears: ["bear"], mix: ["bear", "sphere", "cube"]};

        /**
         * The shapes of a cast's agents, in turn.
         *
         * @throws ArgumentError if there is no such cast
         */
        public static function shapesOf(cast:String):Array
        {
            if (CASTS.indexOf(cast) < 0)
            {
                throw new ArgumentError("the casts are " + CASTS.join(", ") + ", not \"" + cast + "\"");
            }
            return SHAPES[cast];
        }

        /**
         * The thesis's set-up (§6.1): all in one bin, all colliding.
         *
         * @param count how many agents
         * @param cast who they are, one of CASTS
         */
        public static function crowd(count:int, cast:String):Scene
        {
            return new CrowdScene(count, shapesOf(cast));
        }

        /**
         * Agents all over SpaceLand, of such a size that any number of them covers as much of the ground as a thousand of
         * size 1 do: each collides as often.
         *
         * @param count how many agents
         * @param cast who they are, one of CASTS
         */
        public static function scatteredAsDense(count:int, cast:String):Scene
        {
            return new ScatteredScene(count, shapesOf(cast), Math.sqrt(1000 / count));
        }

        /**
         * Agents of size 1 all over SpaceLand: the more there are, the more often each collides.
         *
         * @param count how many agents
         * @param cast who they are, one of CASTS
         */
        public static function scattered(count:int, cast:String):Scene
        {
            return new ScatteredScene(count, shapesOf(cast));
        }
    }
}
