package support
{
    import evaluation.pairs.SeededRandom;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;

    /** The game's twelve models, and others that take long or are odd. */
    public final class SteppedModels
    {
        /** The files of nine of the twelve: what a test that reads them has to list in its FIXTURES. */
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/dragon.dae", "/assets/seagull.dae",
                "/assets/tree.obj", "/assets/kelp.obj", "/assets/fortress.obj", "/assets/spaceship.obj",
                "/assets/fireman.dae", "/assets/person.dae"];

        /** Those that are built in. */
        public static function builtIn():Vector.<Model>
        {
            return new <Model>[BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder()];
        }

        /** All twelve. */
        public static function twelve():Vector.<Model>
        {
            var all:Vector.<Model> = builtIn();
            for each (var file:String in FIXTURES)
            {
                var name:String = nameOf(file);
                all.push(file.slice(-4) == ".dae" ? new ColladaModel(name, Fixtures.text(file))
                        : new ObjModel(name, Fixtures.text(file)));
            }
            return all;
        }

        /** Models of few dimensions, of many vertices, and of nothing but hull. */
        public static function odd():Vector.<Model>
        {
            var random:SeededRandom = new SeededRandom(7);
            return new <Model>[
                    new Model("point", new <Number>[1, 2, 3]),
                    new Model("line", PointSets.turned(PointSets.cloud(random, 50, 1, 0, 0), random)),
                    new Model("plane", PointSets.turned(PointSets.cloud(random, 500, 1, 1, 0), random)),
                    new Model("flat cube", PointSets.box(0.5, 0.5, 0.5, 12)),
                    new Model("cloud", PointSets.turned(PointSets.cloud(random, 5000, 1, 0.5, 0.2), random)),
                    new Model("ball", PointSets.sphere(1, 60, 31))];
        }

        /** What a file's model is called. */
        public static function nameOf(file:String):String
        {
            return file.slice(file.lastIndexOf("/") + 1, file.lastIndexOf("."));
        }

        /** A model as the text of an OBJ file. */
        public static function objText(model:Model):String
        {
            var lines:Array = [];
            var i:int;
            for (i = 0; i < model.vertices.length; i += 3)
            {
                lines.push("v " + model.vertices[i] + " " + model.vertices[i + 1] + " " + model.vertices[i + 2]);
            }
            for (i = 0; i < model.triangles.length; i += 3)
            {
                lines.push("f " + (model.triangles[i] + 1) + " " + (model.triangles[i + 1] + 1) + " "
                        + (model.triangles[i + 2] + 1));
            }
            return lines.join("\n");
        }
    }
}
