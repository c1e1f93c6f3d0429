package support
{
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;

    /** The sets of test/fixtures/fits.json: points, and the minima that are known for them. */
    public final class ReferenceFits
    {
        private static const SETS:Array = ["L", "capsule", "clusters", "cone", "coplanar-polygon", "cross", "cube", "cylinder",
                "duplicates", "far-from-the-origin", "huge", "line-along-x", "line", "long-helix", "nearly-collinear",
                "nearly-coplanar", "normal-cloud", "one-point-repeated", "one-point", "plane", "points-on-a-sphere", "sphere-32x16",
                "tetrahedron", "thin-turned-box", "tiny", "turned-cube", "two-points", "uniform-cloud"];

        // by the names that fits.json has for them
        private static const MODELS:Object = {
                "spider (model)": "/assimp/OBJ/spider.obj",
                "wuson (model)": "/assimp/OBJ/WusonOBJ.obj",
                "box (model)": "/assimp/OBJ/box.obj",
                "duck (model)": "/assimp/Collada/duck.dae",
                "teapots2 (model)": "/assimp/Collada/teapot_instancenodes.DAE",
                "sphere (model)": "/assimp/Collada/sphere.dae",
                "human (model)": "/models/human.dae",
                "bunny (model)": "/models/bunny.obj",
                "teapot (model)": "/models/teapot.obj",
                "dragon4 (model)": "/models/dragon4.obj",
                "dragon3 (model)": "/models/dragon3.obj"
            };

        /** What a test has to list in its FIXTURES. */
        public static const FIXTURES:Array = ["/fixtures/fits.json"].concat(pointFiles(), modelFiles());

        /** The sets: as in the file, those whose points are not there left out. */
        public static function sets():Array
        {
            var result:Array = [];
            // whole numbers above 2^31 come out wrong in Ruffle's JSON: as texts they become the right numbers later
            var text:String = Fixtures.text("/fixtures/fits.json").replace(/: (-?\d{10,})\.0\b/g, ': "$1"');
            for each (var entry:Object in JSON.parse(text)["sets"])
            {
                if (entry.source != "model" || entry.name in MODELS && Fixtures.has(MODELS[entry.name]))
                {
                    result.push(entry);
                }
            }
            return result;
        }

        /** The points of a set, x, y, z each. */
        public static function points(entry:Object):Vector.<Number>
        {
            if (entry.source == "formula")
            {
                return lattice(entry.vertices);
            }
            if (entry.source == "model")
            {
                return modelOf(entry.name).vertices;
            }
            var result:Vector.<Number> = new Vector.<Number>();
            for each (var line:String in Fixtures.text("/fixtures/" + entry.file).split("\n"))
            {
                if (line != "")
                {
                    var words:Array = line.split(" ");
                    result.push(Number(words[0]), Number(words[1]), Number(words[2]));
                }
            }
            return result;
        }

        private static function modelOf(name:String):Model
        {
            var file:String = MODELS[name];
            if (file.slice(-4) == ".obj")
            {
                return new ObjModel(name, Fixtures.text(file), "y");
            }
            return ColladaModel.fromBytes(name, Fixtures.bytes(file));
        }

        private static function lattice(count:int):Vector.<Number>
        {
            var result:Vector.<Number> = new Vector.<Number>(3 * count);
            for (var i:int = 0; i < count; i++)
            {
                var x:Number = i * 0.8191725133961645 % 1 - 0.5;
                result[3 * i] = x;
                result[3 * i + 1] = 0.6 * (i * 0.6710436067037893 % 1 - 0.5) + 0.2 * x;
                result[3 * i + 2] = 0.3 * (i * 0.5497004779019703 % 1 - 0.5);
            }
            return result;
        }

        private static function pointFiles():Array
        {
            var files:Array = [];
            for each (var name:String in SETS)
            {
                files.push("/fixtures/pointsets/" + name + ".txt");
            }
            return files;
        }

        private static function modelFiles():Array
        {
            var files:Array = [];
            for each (var file:String in MODELS)
            {
                files.push(file);
            }
            return files;
        }
    }
}
