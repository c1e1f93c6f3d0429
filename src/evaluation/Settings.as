package evaluation
{
    import evaluation.scenes.Scenes;
    import starlogo.GreatLand;

    /** Selects the parts of the evaluation to run, by the parameters of the SWF. Lists are separated by commas. An empty list means all. */
    public final class Settings
    {
        /** The names of all figures. */
        public static const FIGURES:Array = ["volumes", "fits", "access", "tests", "precision", "hierarchies", "crowds",
                "combination", "experiments", "scattered", "monitor"];

        /** The class names of all colliders. */
        public static const COLLIDERS:Array = ["BinCollider", "TightestFitCollider", "HierarchicalCollider",
                "CombinationCollider"];

        /** The thesis's twelve models. */
        public static const MODELS:Array = ["sphere", "cube", "cylinder", "bear", "dragon", "seagull", "tree", "kelp",
                "fortress", "spaceship", "fireman", "person"];

        /** The figures to run. */
        public var figures:Array;

        /** The colliders to run: names of COLLIDERS, and of a researcher's own classes. */
        public var colliders:Array;

        /** A researcher's own fitters, by the names of their classes. */
        public var fitters:Array;

        /** Makes what is not the engine's. */
        public var own:OwnClasses;

        /** The models for the figures about single models. */
        public var models:Array;

        /** The numbers of agents in crowds. */
        public var crowds:Array;

        /** The numbers of agents in scattered games. */
        public var games:Array;

        /** The casts of scattered games and of the CombinationCollider's crowds. */
        public var casts:Array;

        /** How often a thing is measured. */
        public var repetitions:int;

        /** How often a thing that takes long is measured, unless a number is given. */
        public var longRepetitions:int;

        /** Whether the StarLogo Nova client's models are present. */
        public var hasNova:Boolean;

        /** Whether everything is run. */
        public var isFull:Boolean;

        /**
         * @param parameters the parameters of the SWF
         * @param find finds a class by its name, or null
         * @throws ArgumentError if one names something unknown, or a class of another kind
         */
        public function Settings(parameters:Object, find:Function = null)
        {
            own = new OwnClasses(find);
            isFull = parameters["full"] == "true";
            hasNova = parameters["nova"] == "true";
            figures = chosen("figures", parameters["figures"], FIGURES);
            colliders = named(parameters["colliders"], COLLIDERS);
            for each (var collider:String in colliders)
            {
                Colliders.make(collider, new GreatLand(), own);
            }
            fitters = named(parameters["fitters"], []);
            for each (var fitter:String in fitters)
            {
                own.fitter(fitter);
            }
            models = chosen("models", parameters["models"], MODELS);
            crowds = numbers("agents", parameters["agents"], isFull ? [10, 100, 300] : [10, 100]);
            games = numbers("agents", parameters["agents"], isFull ? [100, 300, 1000, 3000, 10000] : [100, 1000, 10000]);
            casts = isFull ? Scenes.CASTS : ["mix"];
            repetitions = numbers("repetitions", parameters["repetitions"], [isFull ? 11 : 5])[0];
            longRepetitions = numbers("repetitions", parameters["repetitions"], [isFull ? 5 : 3])[0];
        }

        private static function named(list:String, preset:Array):Array
        {
            return list ? list.split(",") : preset;
        }

        private static function chosen(option:String, list:String, all:Array):Array
        {
            var names:Array = named(list, all);
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
