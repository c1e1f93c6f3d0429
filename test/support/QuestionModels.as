package support
{
    import evaluation.pairs.SeededRandom;
    import starlogo.GreatLand;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.CookedModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;

    /** Models of every kind, and lands that nobody has asked yet. */
    public final class QuestionModels
    {
        /** The kinds: solids, figures of the game, surfaces with a border, few dimensions, several parts and shells, odd triangles. */
        public static const NAMES:Array = ["sphere", "cube", "cylinder", "bear", "dragon", "open cube", "sheet", "triangle", "point", "cloud", "apart", "doll",
                "crossed", "hollow", "both windings", "needles"];

        /** Those of few triangles. */
        public static const SMALL:Array = ["cube", "open cube", "triangle", "apart", "doll", "crossed", "hollow", "both windings"];

        /** The files that a test has to list in its FIXTURES. */
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/dragon.dae"];

        private static var sModels:Object = {};
        private static var sCooked:Object = {};

        /** The model of a kind. */
        public static function of(name:String):Model
        {
            sModels[name] ||= make(name);
            return sModels[name];
        }

        /**
         * A new land with some models, whose trees are new too.
         *
         * @param names of the kinds
         * @param areCooked whether the trees are read from cooked files
         */
        public static function land(names:Array, areCooked:Boolean):GreatLand
        {
            var land:GreatLand = new GreatLand();
            land.loadAllBoundingStructures = true;
            // the structures are read in either case, because fitting takes long and is done when a model is added
            land.loadHierarchies = areCooked;
            for each (var name:String in names)
            {
                land.addModel(cooked(name));
                if (!areCooked)
                {
                    land.hierarchies.add(name, of(name).vertices, of(name).triangles);
                }
            }
            return land;
        }

        private static function cooked(name:String):Model
        {
            if (sCooked[name] == null)
            {
                var kitchen:GreatLand = new GreatLand();
                kitchen.loadAllBoundingStructures = true;
                sCooked[name] = CookedModel.fromBytes(name, kitchen.cook(of(name)));
            }
            return sCooked[name];
        }

        private static function make(name:String):Model
        {
            switch (name)
            {
                case "sphere":
                    return BuiltInModel.sphere();
                case "cube":
                    return BuiltInModel.cube();
                case "cylinder":
                    return BuiltInModel.cylinder();
                case "bear":
                    return new ObjModel(name, Fixtures.text(FIXTURES[0]));
                case "dragon":
                    return new ColladaModel(name, Fixtures.text(FIXTURES[1]));
                case "open cube":
                    return SolidModels.openCube();
                case "triangle":
                    return ThinModels.make(name);
                case "point":
                    return ThinModels.make(name);
                case "apart":
                    return SolidModels.apart();
                case "doll":
                    return SolidModels.doll();
                case "crossed":
                    return SolidModels.crossed();
                case "hollow":
                    return SolidModels.hollow();
                case "sheet":
                    return sheet();
                case "cloud":
                    return new Model(name, PointSets.cloud(new SeededRandom(5), 60, 1, 0.7, 0.4));
                case "both windings":
                    var pyramid:Model = SolidModels.wedge(name, 0.7);
                    return new Model(name, pyramid.vertices, new Vector.<uint>().concat(pyramid.triangles, pyramid.triangles.concat().reverse()));
                default:
                    return needles();
            }
        }

        private static function sheet():Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < 49; i++)
            {
                vertices.push(i % 7, int(i / 7), 0);
                if (i % 7 < 6 && i < 42)
                {
                    triangles.push(i, i + 1, i + 8, i, i + 8, i + 7);
                }
            }
            return new Model("sheet", vertices, triangles);
        }

        // Each begins a little after the last one and ends beside it.
        private static function needles():Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < 120; i++)
            {
                vertices.push(i, 0, i / 10, 1000 + (i < 119 ? 0 : 0.5), i, 0, 500, 1, 3);
                triangles.push(3 * i, 3 * i + 1, 3 * i + 2);
            }
            return new Model("needles", vertices, triangles);
        }
    }
}
