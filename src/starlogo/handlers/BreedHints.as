package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.data.isProbablyMisspelt;
    import starlogo.engine;
    import starlogo.search.BreedInterests;

    use namespace engine;

    /** Says what a name may mean that is no agent's breed: the breed of a similar name, or the shape of that name. */
    internal final class BreedHints
    {
        /**
         * The rest of a warning about a name; null if nothing similar is there.
         *
         * @param isThere by number: whether an agent has the breed
         * @param agents one may be null
         * @param interests the breeds that all handlers name; null for a block's breed
         */
        public static function hintFor(name:String, isThere:Vector.<Boolean>, agents:Vector.<Agent>, interests:BreedInterests):String
        {
            for (var number:int = 0; number < isThere.length; number++)
            {
                var breed:String = Breeds.NAMES.nameOf(number);
                if (isThere[number] && (isUnclaimed(number, interests) || stemOf(name) == stemOf(breed)) && isProbablyMisspelt(name, breed))
                {
                    return "; is " + codeOf(breed) + " meant?";
                }
            }
            for each (var agent:Agent in agents)
            {
                if (agent != null && agent.shape == name)
                {
                    return ", which is the shape of " + agent + ": new Agent(\"" + name + "\", \"BREED\") gives it a breed";
                }
            }
            return null;
        }

        // Whether another name may mean a breed: it is that of the ground or the edges, or no handler names it.
        private static function isUnclaimed(number:int, interests:BreedInterests):Boolean
        {
            return Breeds.isEnvironment(number) || interests == null || !interests.isNamed(number);
        }

        // A name without case, and without a plural's s.
        private static function stemOf(name:String):String
        {
            return name.toLowerCase().replace(/s$/, "");
        }

        // How a game's code names a breed.
        private static function codeOf(breed:String):String
        {
            return breed == Breeds.TERRAIN ? "Collision.TERRAIN" : breed == Breeds.EDGE ? "Collision.EDGE" : "\"" + breed + "\"";
        }
    }
}
