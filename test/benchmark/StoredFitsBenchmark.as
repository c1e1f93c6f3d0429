package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import flash.utils.ByteArray;
    import starlogo.GreatLand;
    import starlogo.models.Model;
    import starlogo.steps.finish;
    import support.SteppedModels;

    /**
     * The time to take in models whose fits are known, beside that to compute them: until agents may have their shapes, and with
     * hierarchies and surfaces, which otherwise are made of what is known when they are first needed. Reading the models' files, which
     * both do, is beside it.
     */
    public class StoredFitsBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = SteppedModels.FIXTURES;

        private static const ROUNDS:int = 7;

        private var _plain:GreatLand = new GreatLand();
        private var _exact:GreatLand = new GreatLand();

        /** The table. */
        public function run():String
        {
            _exact.prepareExact = true;
            var models:Vector.<Model> = SteppedModels.twelve();
            var baked:Vector.<ByteArray> = new Vector.<ByteArray>();
            var all:Vector.<Measurement> = new Vector.<Measurement>();
            var bytes:int = 0;
            for each (var model:Model in models)
            {
                baked.push(_plain.bake(model));
                bytes += baked[baked.length - 1].length;
                addTo(all, new <Model>[model], new <ByteArray>[baked[baked.length - 1]]);
            }
            addTo(all, models, baked);
            all.push(new Measurement("files", SteppedModels.twelve, 1));
            Measurement.runAll(all, ROUNDS);
            var table:Table = new Table("fits of", "triangles", "bytes", "known ms", "computed ms", "times", "known, all of it ms",
                    "computed, all of it ms", "times");
            for (var i:int = 0; i <= models.length; i++)
            {
                var isAll:Boolean = i == models.length;
                table.add(isAll ? "all twelve" : models[i].name, isAll ? "" : models[i].triangles.length / 3, isAll ? bytes : baked[i].length,
                        ms(all[4 * i]), ms(all[4 * i + 1]), all[4 * i + 1].timesAsLongAs(all[4 * i]).toFixed(1), ms(all[4 * i + 2]),
                        ms(all[4 * i + 3]), all[4 * i + 3].timesAsLongAs(all[4 * i + 2]).toFixed(1));
            }
            return table + "\nto read the twelve models' files: " + ms(all[all.length - 1]) + " ms";
        }

        private function addTo(all:Vector.<Measurement>, models:Vector.<Model>, baked:Vector.<ByteArray>):void
        {
            all.push(taking(_plain, models, baked), taking(_plain, models, null), taking(_exact, models, baked), taking(_exact, models, null));
        }

        private static function taking(land:GreatLand, models:Vector.<Model>, baked:Vector.<ByteArray>):Measurement
        {
            return new Measurement(models[0].name, function():void
                {
                    for (var i:int = 0; i < models.length; i++)
                    {
                        finish(land.receiveWithFits(models[i], baked == null ? null : baked[i]));
                    }
                }, 1);
        }

        private static function ms(measurement:Measurement):String
        {
            return (measurement.nanoseconds / 1e6).toFixed(2);
        }
    }
}
