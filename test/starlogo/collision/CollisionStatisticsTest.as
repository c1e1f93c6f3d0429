package starlogo.collision
{
    import flash.utils.describeType;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    public class CollisionStatisticsTest
    {
        [Test]
        public function copiesAndResetsEveryNumber():void
        {
            var from:CollisionStatistics = new CollisionStatistics();
            var names:Vector.<String> = new Vector.<String>();
            for each (var variable:XML in describeType(from).variable)
            {
                names.push(variable.@name);
            }
            assertTrue(names.length + " numbers", names.length >= 18);
            for (var i:int = 0; i < names.length; i++)
            {
                from[names[i]] = i + 1;
            }
            var to:CollisionStatistics = new CollisionStatistics();
            to.copyFrom(from);
            for (i = 0; i < names.length; i++)
            {
                assertEquals(names[i], i + 1, to[names[i]]);
            }
            to.reset();
            for each (var name:String in names)
            {
                assertEquals(name, 0, to[name]);
            }
        }

        [Test]
        public function itsTextHasTheMainCounts():void
        {
            var statistics:CollisionStatistics = new CollisionStatistics();
            statistics.agents = 100;
            statistics.candidatePairs = 12;
            statistics.collisions = 3;
            statistics.handlerCalls = 6;
            statistics.frameMs = 2;
            assertEquals("100 agents, 12 candidates, 3 collisions, 6 calls of handlers, 2 ms", String(statistics));
        }

        [Test]
        public function testsAreThoseOfAllPairsOfStructures():void
        {
            var statistics:CollisionStatistics = new CollisionStatistics();
            statistics.sphereSphereTests = 1;
            statistics.sphereCapsuleTests = 20;
            statistics.sphereBoxTests = 300;
            statistics.capsuleCapsuleTests = 4000;
            statistics.capsuleBoxTests = 50000;
            statistics.boxBoxTests = 600000;
            statistics.nodeVisits = statistics.triangleTests = statistics.hierarchyTests = 7;
            assertEquals(654321, statistics.tests);
        }
    }
}
