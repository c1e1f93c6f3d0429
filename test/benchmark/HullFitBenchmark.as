package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.models.Model;
    import support.SteppedModels;

    /** The time to find the tightest sphere, capsule or box of models, and the time with their hulls of 16 corners. */
    public class HullFitBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = SteppedModels.FIXTURES;

        private static const ROUNDS:int = 9;

        private var _models:Vector.<Model>;

        /** The table. */
        public function run():String
        {
            _models = SteppedModels.twelve();
            var all:Vector.<Measurement> = new Vector.<Measurement>();
            for (var i:int = 0; i < _models.length; i++)
            {
                all.push(loading(i, i + 1, false), loading(i, i + 1, true));
            }
            all.push(loading(0, _models.length, false), loading(0, _models.length, true));
            Measurement.runAll(all, ROUNDS);
            var table:Table = new Table("model", "vertices", "tightest ms", "with a hull ms", "times");
            for (i = 0; i <= _models.length; i++)
            {
                var isAll:Boolean = i == _models.length;
                table.add(isAll ? "all twelve" : _models[i].name, isAll ? "" : _models[i].vertices.length / 3, all[2 * i].ms, all[2 * i + 1].ms,
                        all[2 * i + 1].timesAsLongAs(all[2 * i]).toFixed(2));
            }
            return table.toString();
        }

        private function loading(first:int, end:int, keepHulls:Boolean):Measurement
        {
            return new Measurement(_models[first].name, function():void
                {
                    var library:BoundingStructuresLibrary = new BoundingStructuresLibrary();
                    library.keepHulls = keepHulls;
                    for (var i:int = first; i < end; i++)
                    {
                        library.add(_models[i].name, _models[i].vertices);
                    }
                }, 1);
        }
    }
}
