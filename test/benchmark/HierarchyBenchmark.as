package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Fixtures;

    /** The time to build the hierarchy of each model, beside the thesis's (Figure 6-5, whose other models are not public). */
    public class HierarchyBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/dragon.dae", "/assets/seagull.dae", "/assets/tree.obj",
                "/assets/kelp.obj", "/assets/fortress.obj", "/assets/spaceship.obj", "/assets/fireman.dae", "/assets/person.dae"];

        private static const ROUNDS:int = 5;
        private static const THESIS_MS:Object = {sphere: 0.536, cube: 0.066, cylinder: 1.685, bear: 3.722, dragon: 25.542, seagull: 7.728,
                tree: 3.964, kelp: 0.359, fortress: 3.874, spaceship: 3.016, fireman: 10.479, person: 5.551};

        private var _library:HierarchiesLibrary = new HierarchiesLibrary();

        /** The table. */
        public function run():String
        {
            var models:Vector.<Model> = new <Model>[BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder()];
            for each (var address:String in FIXTURES)
            {
                models.push(read(address));
            }
            var all:Vector.<Measurement> = new Vector.<Measurement>();
            for each (var model:Model in models)
            {
                all.push(building(model, false), building(model, true));
            }
            Measurement.runAll(all, ROUNDS);
            var table:Table = new Table("to build a hierarchy of", "vertices", "triangles", "of triangles ms", "times the sphere's",
                    "of vertices ms", "times the sphere's", "thesis ms", "times the sphere's");
            for (var i:int = 0; i < models.length; i++)
            {
                model = models[i];
                table.add(model.name, model.vertices.length / 3, model.triangles.length / 3, ms(all[2 * i + 1]), ratio(all[2 * i + 1], all[1]),
                        ms(all[2 * i]), ratio(all[2 * i], all[0]), THESIS_MS[model.name], (THESIS_MS[model.name] / THESIS_MS.sphere).toFixed(1));
            }
            return String(table);
        }

        private static function read(address:String):Model
        {
            var name:String = address.match(/(\w+)\.\w+$/)[1];
            if (/obj$/.test(address))
            {
                return new ObjModel(name, Fixtures.text(address));
            }
            return new ColladaModel(name, Fixtures.text(address));
        }

        private function building(model:Model, triangles:Boolean):Measurement
        {
            return new Measurement(model.name, function():void
                {
                    _library.add(model.name, model.vertices, triangles ? model.triangles : null);
                }, 1);
        }

        private static function ms(measurement:Measurement):String
        {
            return (measurement.nanoseconds / 1e6).toFixed(3);
        }

        private static function ratio(measurement:Measurement, to:Measurement):String
        {
            return (measurement.nanoseconds / to.nanoseconds).toFixed(1);
        }
    }
}
