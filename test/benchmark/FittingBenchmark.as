package benchmark
{
    import evaluation.literal.BulkOrientedBoxFit;
    import evaluation.literal.LiteralOrientedBoxFit;
    import flash.utils.getTimer;
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.FitSession;
    import starlogo.fitting.MinimalCapsuleFitter;
    import starlogo.fitting.MinimalSphereFitter;
    import starlogo.geometry.ConvexHull;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Fixtures;

    /**
     * Times finding the tightest fit with the default fitters against the thesis's brute force over all vertices, per
     * model, with the thesis's own times (Figure 6-2) beside it; and the best fits that are known.
     */
    public final class FittingBenchmark
    {
        /** The models: those of the game, then real ones. */
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/dragon.dae", "/assets/seagull.dae", "/assets/tree.obj",
                "/assets/kelp.obj", "/assets/fortress.obj", "/assets/spaceship.obj", "/assets/fireman.dae", "/assets/person.dae",
                "/models/bunny.obj", "/models/teapot.obj", "/models/dragon4.obj"];

        // Figure 6-2: ms to find the tightest fit
        private static const THESIS_MS:Object = {sphere: 223, cube: 27, cylinder: 318, bear: 555, dragon: 3000, seagull: 924,
                tree: 416, kelp: 67, fortress: 398, spaceship: 240, fireman: 1061, person: 578};
        private static const DEG_INCREMENT:Number = 10;
        private static const TARGET:Number = 10;
        private static const KINDS:Array = ["sphere", "capsule", "box"];

        private var _lines:Array = [];
        private var _areFast:Boolean = true;
        private var _areSmall:Boolean = true;

        public function FittingBenchmark()
        {
        }

        /** Measures, and returns the table. */
        public function run():String
        {
            _lines.push(row(["model", "vertices", "on hull", "thesis ms", "literal ms", "bulk ms", "ms", "times", "(bulk)", "hull ms", "tightest", "volume", "box",
                            "literal box", "min. sphere", "min. capsule", "their ms"]));
            // the player compiles what runs often: the first model would pay for it
            measure(BuiltInModel.sphere());
            _lines.length = 1;
            _areFast = _areSmall = true;
            for each (var model:Model in models())
            {
                measure(model);
            }
            _lines.push("at least " + TARGET + " times faster: " + (_areFast ? "all" : "NOT ALL") + "; box not larger: "
                    + (_areSmall ? "all" : "NOT ALL"));
            return _lines.join("\n");
        }

        private function measure(model:Model):void
        {
            var library:BoundingStructuresLibrary = new BoundingStructuresLibrary(DEG_INCREMENT);
            library.keepAll = true;
            var start:int = getTimer();
            var literalFit:BulkOrientedBoxFit = new BulkOrientedBoxFit(model.vertices, DEG_INCREMENT);
            var bulkMs:Number = getTimer() - start;
            // a ninth of the rotations: all of them would leave more objects than the player can hold in one call
            var literalMs:Number = 90 / DEG_INCREMENT * median(function():void
                {
                    new LiteralOrientedBoxFit(model.vertices, DEG_INCREMENT, DEG_INCREMENT);
                }, 1);
            var ms:Number = median(function():void
                {
                    library.add(model.name, model.vertices);
                });
            var hullMs:Number = median(function():void
                {
                    new ConvexHull(model.vertices);
                });
            start = getTimer();
            var session:FitSession = new FitSession(model.vertices);
            var sphere:BoundingStructure = new MinimalSphereFitter().fitOnce(session);
            var capsule:BoundingStructure = new MinimalCapsuleFitter().fitOnce(session);
            var minimalMs:Number = getTimer() - start;
            var tightest:BoundingStructure = library.tightestFit(model.name);
            _areFast = _areFast && literalMs >= TARGET * ms;
            _areSmall = _areSmall && library.box(model.name).volume <= literalFit.volume * (1 + 1e-6);
            _lines.push(row([model.name, model.vertices.length / 3, session.hull.indices.length, THESIS_MS[model.name] || "-",
                            literalMs.toFixed(0), bulkMs.toFixed(0), ms.toFixed(1), (literalMs / ms).toFixed(0), (bulkMs / ms).toFixed(0), hullMs.toFixed(1), KINDS[tightest.kind],
                            tightest.volume.toFixed(3), library.box(model.name).volume.toFixed(4), literalFit.volume.toFixed(4),
                            sphere.volume.toFixed(3), capsule.volume.toFixed(3), minimalMs.toFixed(0)]));
        }

        // Of some samples, each long enough for a clock that counts milliseconds.
        private static function median(call:Function, samples:int = 5):Number
        {
            var times:Array = [];
            for (var sample:int = 0; sample < samples; sample++)
            {
                var calls:int = 0;
                var start:int = getTimer();
                do
                {
                    call();
                    calls++;
                }
                while (getTimer() - start < 15);
                times.push((getTimer() - start) / calls);
            }
            times.sort(Array.NUMERIC);
            return times[int(samples / 2)];
        }

        private static function models():Vector.<Model>
        {
            var all:Vector.<Model> = new <Model>[BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder()];
            for each (var file:String in FIXTURES)
            {
                if (!Fixtures.has(file))
                {
                    continue;
                }
                var name:String = file.slice(file.lastIndexOf("/") + 1, file.lastIndexOf("."));
                var isReal:Boolean = file.indexOf("/models/") == 0;
                all.push(file.slice(-4) == ".dae" ? new ColladaModel(name, Fixtures.text(file))
                        : new ObjModel(name, Fixtures.text(file), isReal ? "y" : "z"));
            }
            return all;
        }

        private static function row(cells:Array):String
        {
            var line:String = "";
            for (var i:int = 0; i < cells.length; i++)
            {
                var cell:String = String(cells[i]);
                while (cell.length < (i == 0 ? 10 : 11))
                {
                    cell = i == 0 ? cell + " " : " " + cell;
                }
                line += cell + " ";
            }
            return line;
        }
    }
}
