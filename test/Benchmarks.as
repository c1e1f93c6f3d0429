package
{
    import benchmark.BroadPhaseBenchmark;
    import benchmark.CookedBenchmark;
    import benchmark.DistanceBenchmark;
    import benchmark.FewMoveBenchmark;
    import benchmark.GroundBenchmark;
    import benchmark.GroundContactsBenchmark;
    import benchmark.HullFitBenchmark;
    import benchmark.MoveBenchmark;
    import benchmark.PairBenchmark;
    import benchmark.QueriesBenchmark;
    import benchmark.RayBenchmark;
    import benchmark.ReadingBenchmark;
    import benchmark.TraversalBenchmark;
    import flash.display.Sprite;
    import flash.events.Event;
    import headless.Host;
    import support.Fixtures;

    /**
     * The benchmark SWF: runs every benchmark, one a frame, and prints what it returns. A benchmark is a class with a
     * method <code>run():String</code>, and perhaps a static FIXTURES as tests have; the parameter <code>benchmark</code> picks those whose name contains it.
     */
    public class Benchmarks extends Sprite
    {
        private static const BENCHMARKS:Array = [BroadPhaseBenchmark, FewMoveBenchmark, GroundBenchmark, GroundContactsBenchmark, TraversalBenchmark, PairBenchmark, DistanceBenchmark,
                MoveBenchmark, QueriesBenchmark, RayBenchmark, ReadingBenchmark, CookedBenchmark, HullFitBenchmark];

        private var _pending:Array;

        public function Benchmarks()
        {
            var pattern:String = loaderInfo.parameters["benchmark"] || "";
            _pending = BENCHMARKS.filter(function(benchmark:Class, index:int, all:Array):Boolean
                {
                    return String(benchmark).indexOf(pattern) >= 0;
                });
            Fixtures.load(Fixtures.listOf(_pending), start);
        }

        private function start():void
        {
            trace("in " + Host.player);
            addEventListener(Event.ENTER_FRAME, onEnterFrame);
        }

        private function onEnterFrame(event:Event):void
        {
            if (_pending.length == 0)
            {
                removeEventListener(Event.ENTER_FRAME, onEnterFrame);
                Host.exit(0);
                return;
            }
            var benchmark:Class = _pending.shift();
            trace(String(benchmark));
            trace(new benchmark().run());
        }
    }
}
