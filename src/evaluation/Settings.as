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

        private static const OPTIONS:Array = ["figures", "colliders", "fitters", "models", "agents", "repetitions"];

        private var _options:Object = {};

        // The entries that are measured again, and for each of them its row; null for all that the figures have.
        private var _wanted:Object = null;

        /**
         * @param parameters the parameters of the SWF
         * @param find finds a class by its name, or null
         * @throws ArgumentError if one names something unknown, or a class of another kind
         */
        public function Settings(parameters:Object, find:Function = null)
        {
            own = new OwnClasses(find);
            for each (var option:String in OPTIONS)
            {
                if (parameters[option])
                {
                    _options[option] = parameters[option];
                }
            }
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
            if (parameters["entries"])
            {
                want(parameters["entries"].split(";"));
            }
        }

        /**
         * Whether a part of a figure is run.
         *
         * @param figure the figure
         * @param subject the row
         * @param variant the column of a game; null for a row with all of its columns
         */
        public function isWanted(figure:String, subject:String, variant:String = null):Boolean
        {
            return _wanted == null || keyOf(figure, subject, variant) in _wanted;
        }

        /** What the report says of the run: its numbers, and the options that were given. */
        public function get described():Object
        {
            return {full: isFull, repetitions: repetitions, longRepetitions: longRepetitions, crowds: crowds, games: games, refused: _wanted != null,
                    options: _options};
        }

        // Takes the entries that a report lacks: "figure / subject / variant", each encoded as a part of an address. The games are those of the entries.
        private function want(entries:Array):void
        {
            _wanted = {};
            crowds = [];
            games = [];
            casts = Scenes.CASTS;
            if (_options["colliders"])
            {
                colliders = COLLIDERS.concat(colliders.filter(isOwn));
            }
            for each (var text:String in entries)
            {
                var parts:Array = decodeURIComponent(text).split(" / ");
                _wanted[keyOf(parts[0], parts[1])] = true;
                _wanted[keyOf(parts[0], parts[1], parts[2].replace(/, literal$/, ""))] = true;
                var counts:Array = parts[0] == "crowds" ? crowds : parts[0] == "scattered" ? games : [];
                if (counts.indexOf(parseInt(parts[1])) < 0)
                {
                    counts.push(parseInt(parts[1]));
                }
            }
        }

        private static function isOwn(name:String, index:int, all:Array):Boolean
        {
            return COLLIDERS.indexOf(name) < 0;
        }

        private static function keyOf(...parts):String
        {
            return parts[2] == null ? parts[0] + " / " + parts[1] : parts.join(" / ");
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
