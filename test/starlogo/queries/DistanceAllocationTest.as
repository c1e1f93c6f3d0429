package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import support.EachCollider;
    import support.Garbage;
    import support.MemoryGrowth;

    /** Distances leave nothing for the collector, in any system; see collision.AllocationTest. */
    public class DistanceAllocationTest
    {
        // bytes in all, less than a small object for each question; in Adobe's VM some pages
        private static const NOTHING:Number = 2000;
        private static const PAGES:Number = 3 * 4096;

        // rounds in which all turn about once
        private static const TURN:int = 6;

        [Test]
        public function allocatesNothing():void
        {
            Garbage.assumeKept();
            var greatLand:GreatLand = new GreatLand();
            greatLand.addModel(BuiltInModel.sphere());
            greatLand.addModel(BuiltInModel.cube());
            greatLand.addModel(BuiltInModel.cylinder());
            for each (var name:String in EachCollider.NAMES)
            {
                check(name, new AgentQueries(EachCollider.make(name, greatLand)));
            }
        }

        private static function check(name:String, queries:AgentQueries):void
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            var random:SeededRandom = new SeededRandom(2241);
            for (var i:int = 0; i < 20; i++)
            {
                var agent:Agent = new Agent(random.pick(["sphere", "cube", "cylinder"]));
                agent.moveTo(random.between(-3, 3), random.between(-3, 3), random.between(0, 1));
                agent.pitch = random.pick([0, 30]);
                agent.hierarchical = i % 3 == 0;
                agents.push(agent);
            }
            queries.update(agents);
            var pointA:Vector3D = new Vector3D();
            var pointB:Vector3D = new Vector3D();
            var times:int = Garbage.isCounted ? 200 : TURN;
            var grown:Number = MemoryGrowth.during(times, TURN, function(round:int):void
                {
                    for (var k:int = 1; k < 20; k++)
                    {
                        queries.distance(agents[k], agents[k - 1], pointA, pointB);
                        agents[k].heading += 360 / TURN;
                        queries.moved(agents[k]);
                    }
                });
            trace("  " + name + ": " + grown + " bytes in " + 20 * times + " questions");
            assertTrue(name + ": " + grown + " bytes", grown <= (Garbage.isCounted ? PAGES : NOTHING));
        }
    }
}
