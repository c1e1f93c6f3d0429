package evaluation
{
    import evaluation.scenes.Scenes;

    /** What of the evaluation is run, from the parameters of the SWF. Lists are separated by commas; an empty one is all. */
    public final class Settings
    {
        /** The figures, by what they show. */
        public static const FIGURES:Array = ["volumes", "fits", "access", "tests", "hierarchies", "crowds", "combination",
                "scattered", "monitor"];

        /** The colliders' classes, by name. */
        public static const COLLIDERS:Array = ["BinCollider", "TightestFitCollider", "HierarchicalCollider",
                "CombinationCollider"];

        /** The thesis's twelve models. */
        public static const MODELS:Array = ["sphere", "cube", "cylinder", "bear", "dragon", "seagull", "tree", "kelp",
                "fortress", "spaceship", "fireman", "person"];

        /** The figures that are run. */
        public var figures:Array;

        /** The colliders that are run. */
        public var colliders:Array;

        /** The models of the figures about single models. */
        public var models:Array;

        /** How many agents there are in a crowd. */
        public var crowds:Array;

        /** How many agents there are in a scattered game. */
        public var games:Array;

        /** Who the agents of scattered games and of the CombinationCollider's crowds are. */
        public var casts:Array;

        /** How often a thing is measured. */
        public var repetitions:int;

        /** How often a thing is measured that takes long: as often as in a quick run, unless a number is asked for. */
        public var longRepetitions:int;

        /** Whether the StarLogo Nova client's models are there. */
        public var hasNova:Boolean;

        /** Whether everything is run. */
        public var isFull:Boolean;

        /**
         * @param parameters the parameters of the SWF
         * @throws ArgumentError if one names what is not there
         */
        public function Settings(parameters:Object)
        {
            isFull = parameters["full"] == "true";
            hasNova = parameters["nova"] == "true";
            figures = chosen("figures", parameters["figures"], FIGURES);
            colliders = chosen("colliders", parameters["colliders"], COLLIDERS);
            models = chosen("models", parameters["models"], MODELS);
            crowds = numbers("agents", parameters["agents"], isFull ? [10, 100, 300] : [10, 100]);
            games = numbers("agents", parameters["agents"], isFull ? [100, 300, 1000, 3000, 10000] : [100, 1000, 10000]);
            casts = isFull ? Scenes.CASTS : ["mix"];
            repetitions = numbers("repetitions", parameters["repetitions"], [isFull ? 11 : 5])[0];
            longRepetitions = numbers("repetitions", parameters["repetitions"], [5])[0];
        }

        private static function chosen(option:String, list:String, all:Array):Array
        {
            if (!list)
            {
                return all;
            }
            var names:Array = list.split(",");
            for each (var name:String in names)
            {
                if (all.indexOf(name) < 0)
                {
                    throw new ArgumentError("-D" + option + ": there is no \"" + name + "\"; there are " + all.join(","));
                }
            }
            return names;
        }

        private static function numbers(option:String, list:String, preset:Array):Array
        {
            if (!list)
            {
                return preset;
            }
            var all:Array = [];
            for each (var text:String in list.split(","))
            {
                var number:int = int(text);
                if (number < 1 || String(number) != text)
                {
                    throw new ArgumentError("-D" + option + ": numbers of at least 1 are needed, not \"" + text + "\"");
                }
                all.push(number);
            }
            return all;
        }
    }
}
