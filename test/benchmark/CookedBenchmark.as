package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import flash.utils.ByteArray;
    import starlogo.GreatLand;
    import starlogo.models.ColladaModel;
    import starlogo.models.CookedModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Fixtures;
    import support.SteppedModels;

    /**
     * The time to load models that are cooked, beside that to read their files and compute: until agents may have their shapes, and with hierarchies
     * and surfaces, which otherwise are made of what is known when they are first needed. The built-in models have no files.
     */
    public class CookedBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = SteppedModels.FIXTURES;

        private static const ROUNDS:int = 7;

        private var _plain:GreatLand = new GreatLand();
        private var _exact:GreatLand = new GreatLand();
        private var _texts:Vector.<String> = new Vector.<String>();

        /** The table. */
        public function run():String
        {
            _exact.prepareExact = true;
            var models:Vector.<Model> = SteppedModels.twelve();
            var cooked:Vector.<ByteArray> = new Vector.<ByteArray>();
            var all:Vector.<Measurement> = new Vector.<Measurement>();
            var bytes:int = 0;
            for (var i:int = 0; i < models.length; i++)
            {
                cooked.push(_plain.cook(models[i]));
                _texts.push(i < 3 ? null : Fixtures.text(FIXTURES[i - 3]));
                bytes += cooked[i].length;
                addTo(all, models, cooked, i, i + 1);
            }
            addTo(all, models, cooked, 0, models.length);
            Measurement.runAll(all, ROUNDS);
            var table:Table = new Table("model", "triangles", "bytes", "cooked ms", "read and computed ms", "times", "cooked, all of it ms",
                    "read and computed, all of it ms", "times");
            for (i = 0; i <= models.length; i++)
            {
                var isAll:Boolean = i == models.length;
                table.add(isAll ? "all twelve" : models[i].name, isAll ? "" : models[i].triangles.length / 3, isAll ? bytes : cooked[i].length,
                        all[4 * i].ms, all[4 * i + 1].ms, all[4 * i + 1].timesAsLongAs(all[4 * i]).toFixed(1), all[4 * i + 2].ms,
                        all[4 * i + 3].ms, all[4 * i + 3].timesAsLongAs(all[4 * i + 2]).toFixed(1));
            }
            return table.toString();
        }

        private function addTo(all:Vector.<Measurement>, models:Vector.<Model>, cooked:Vector.<ByteArray>, first:int, end:int):void
        {
            for each (var land:GreatLand in [_plain, _exact])
            {
                all.push(loading(land, models, cooked, first, end), loading(land, models, null, first, end));
            }
        }

        private function loading(land:GreatLand, models:Vector.<Model>, cooked:Vector.<ByteArray>, first:int, end:int):Measurement
        {
            return new Measurement(models[first].name, function():void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        land.addModel(cooked == null ? read(models[i], i) : CookedModel.fromBytes(models[i].name, cooked[i]));
                    }
                }, 1);
        }

        private function read(model:Model, i:int):Model
        {
            if (_texts[i] == null)
            {
                return new Model(model.name, model.vertices, model.triangles);
            }
            return FIXTURES[i - 3].slice(-4) == ".dae" ? new ColladaModel(model.name, _texts[i]) : new ObjModel(model.name, _texts[i]);
        }
    }
}
