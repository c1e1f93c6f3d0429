package growth
{
    import flash.events.Event;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;

    /** The measurement finds what grows too fast, and every row can be measured. */
    public class GrowthTest
    {
        private var _ms:Number = 0;

        [Test]
        public function exponents():void
        {
            assertEquals(1, GrowthRun.exponentOf([10, 20, 40], 1));
            assertEquals(2, GrowthRun.exponentOf([10, 40, 160], 1));
            assertEquals(0, GrowthRun.exponentOf([0.01, 1, 5], 8));
        }

        [Test(async, timeout="330000")]
        public function aQuadraticRowFailsAndALinearOneDoesNot():void
        {
            var run:GrowthRun = new GrowthRun([
                        new GrowthRow("quadratic", "things", 100, 1000000, function(n:int, row:GrowthRow):Function
                            {
                                return steps(n * n);
                            }),
                        new GrowthRow("linear", "things", 10000, 1 << 30, function(n:int, row:GrowthRow):Function
                            {
                                return steps(n);
                            })]);
            run.clock = function():Number
            {
                return _ms;
            };
            Async.handleEvent(this, run, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals("quadratic: too slow", run.failures.join());
                }, 275000);
            run.start();
        }

        [Test]
        public function everyRowCanBeMeasured():void
        {
            var names:Object = {};
            for each (var row:GrowthRow in GrowthRows.all)
            {
                assertTrue(row.name, !names.hasOwnProperty(row.name) && row.least < row.most);
                names[row.name] = true;
                assertTrue(row.name, row.begin(row.least)() != null);
            }
            assertTrue(GrowthRows.all.length > 50);
            assertEquals(GrowthRows.named("OBJ:").length, GrowthRows.named("OBJ: ").length);
        }

        // What takes so many steps on a machine that takes a microsecond for each, and no time for anything else.
        private function steps(count:Number):Function
        {
            return function():Object
            {
                _ms += count / 1000;
                return null;
            };
        }
    }
}
